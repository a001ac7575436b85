"""The modulus of a pad from a data sheet."""

from __future__ import annotations

import typing

from taxel import _core
from taxel.errors import Error


def material(
    preset: str | None = None,
    *,
    thickness: float,
    youngs: float | None = None,
    poisson: float | None = None,
    bonded: bool = False,
    contact_radius: float | None = None,
    cylinder: bool = False,
) -> dict[str, typing.Any]:
    """Returns the modulus of a pad for an elastic layer, as `taxel material` does.

    Give the word of a known elastomer (`taxel material --list`), or `youngs` [Pa] and `poisson`. With `contact_radius`
    [m], that of the contact surface, the force at this contact is that of linear elasticity; without it the layer is
    thin against the contact. Keys of the result: `modulus` and `thickness`, as in a layout's material;
    `thin_layer_modulus`; `holds_from` and `holds_to`, the contact radii between which the force is right within 10 %,
    or None; `poisson_limit`, from which on the thin-layer modulus is too large by more than 10 %, or None. Raises Error.

        taxel.material("ecoflex-00-30", thickness=0.002, bonded=True, contact_radius=0.002)["modulus"]
    """
    if preset is not None:
        elastomers = _core.elastomers()
        if youngs is not None:
            raise Error("material", "youngs", "excludes the elastomer")
        if preset not in elastomers:
            raise Error("material", "preset", f"{preset} is unknown, there are {', '.join(elastomers)}")
        youngs = elastomers[preset]["youngs"]
        poisson = elastomers[preset]["poisson"] if poisson is None else poisson
    if youngs is None or poisson is None:
        raise Error("material", "poisson" if poisson is None else "youngs", "is missing: it goes with an own solid")
    return _core.material(youngs, poisson, thickness, bonded, contact_radius, cylinder)
