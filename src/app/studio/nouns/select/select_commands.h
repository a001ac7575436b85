// Commands about the selection.
#pragma once

#include "app/studio/frame/command.h"

namespace taxel::ui {

struct SelectAll {};
struct SelectNone {};
struct InvertSelection {};
struct SelectParentBody {};

void carry_out(const SelectAll& command, App& app);
void carry_out(const SelectNone& command, App& app);
void carry_out(const InvertSelection& command, App& app);
void carry_out(const SelectParentBody& command, App& app);

}  // namespace taxel::ui
