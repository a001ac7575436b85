// Commands: values that say what keys, menus, panels and tools can have done.
#pragma once

#include <concepts>
#include <memory>
#include <utility>

namespace taxel::studio {
struct Host;
}

namespace taxel::ui {

struct App;

/// The functions of one kind of command.
struct CommandKind {
  void (*in_interface)(const void* command, App& app) = nullptr;       ///< or null for a command to the program
  void (*in_host)(const void* command, studio::Host& host) = nullptr;  ///< or null for one about the interface
  bool (*are_equal)(const void* a, const void* b) = nullptr;
};

/// Whether a command is about the interface alone, so that it takes effect at once.
template <class C>
concept InterfaceCommand = requires(const C& command, App& app) {
  carry_out(command, app);
};

/// Whether a command changes the document or the run.
template <class C>
concept HostCommand = requires(const C& command, studio::Host& host) {
  carry_out(command, host);
};

template <class C>
constexpr CommandKind make_command_kind() {
  CommandKind kind;
  if constexpr (InterfaceCommand<C>) {
    kind.in_interface = [](const void* command, App& app) { carry_out(*static_cast<const C*>(command), app); };
  } else {
    kind.in_host = [](const void* command, studio::Host& host) { carry_out(*static_cast<const C*>(command), host); };
  }
  kind.are_equal = [](const void* a, const void* b) {
    if constexpr (std::equality_comparable<C>) return *static_cast<const C*>(a) == *static_cast<const C*>(b);
    return true;
  };
  return kind;
}

/// A command of any kind. Its struct lies with its noun, in one header with the function that carries it out:
/// carry_out(const C&, App&) if it is about the interface alone, or carry_out(const C&, studio::Host&), which also
/// changes the document and the run and is called after the interface was laid out, in the order of the commands.
class Command {
 public:
  template <class C>
  requires(!std::same_as<C, Command> && (InterfaceCommand<C> || HostCommand<C>))
      Command(C command)  // NOLINT: a command of one kind is a command
      : kind_(&kKind<C>), command_(std::make_shared<const C>(std::move(command))) {}

  /// Returns the command if it is of this kind, otherwise null.
  template <class C>
  [[nodiscard]] const C* get_if() const {
    return kind_ == &kKind<C> ? static_cast<const C*>(command_.get()) : nullptr;
  }
  template <class C>
  [[nodiscard]] bool is() const {
    return kind_ == &kKind<C>;
  }
  [[nodiscard]] bool is_about_interface() const { return kind_->in_interface != nullptr; }
  /// The command must be about the interface.
  void carry_out(App& app) const { kind_->in_interface(command_.get(), app); }
  /// The command must not be about the interface.
  void carry_out(studio::Host& host) const { kind_->in_host(command_.get(), host); }
  /// Whether both are of one kind and have the same values, if these can be compared.
  [[nodiscard]] bool operator==(const Command& other) const {
    return kind_ == other.kind_ && kind_->are_equal(command_.get(), other.command_.get());
  }

 private:
  template <class C>
  static constexpr CommandKind kKind = make_command_kind<C>();

  const CommandKind* kind_;
  std::shared_ptr<const void> command_;
};

}  // namespace taxel::ui
