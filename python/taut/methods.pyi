"""Made from the descriptions by python/tools/make_stub.py; do not edit. `./dev python stub` makes it again.

schema: aae8f5e1c103c7bb24225c0a0a7f5313f4e7d0590ea7d9aa9152a804c14c4427
"""

from collections.abc import Mapping, Sequence
from typing import Any, Literal

from ._result import Result
from ._run import Progress
from ._units import Quantity

def mast_section(
    *,
    skyline_force: Quantity,
    mainline_force: Quantity,
    skyline_block_height: Quantity,
    mainline_block_height: Quantity | None = None,
    block_friction: Quantity | None = None,
    wrap: Literal["geometric", "paper"] | None = None,
    paid_out_force: Quantity | None = None,
    branch_angle: Quantity | None = None,
    span: Mapping[str, Any] | None = None,
    allowable_stress: Quantity | None = None,
    steel: str | Quantity | None = None,
    safety: Quantity | None = None,
    tube_ratio: Quantity | None = None,
    section: str | Quantity | None = None,
    choose_section: Mapping[str, Any] | None = None,
    guys: Sequence[Mapping[str, Any] | str] | None = None,
    lateral_force: Quantity | None = None,
    base: Literal["clamped", "hinged"] | None = None,
    checks: Mapping[str, Any] | None = None,
    design: Mapping[str, Any] | None = None,
    title: str | None = None,
    display: Mapping[str, str] | None = None,
    progress: Progress | None = None,
) -> Result:
    """Mast section of a tractor-mounted cable yarder.

    A. O. Shoshin, A. V. Dorozhko, V. Shtollmann, S. V. Yarmolik: Method for determining the parameters of the tower
    section of a cable yarding based on a tractor. Proceedings of BSTU, issue 1, 2022, no. 1 (252), pp. 155-164 (in
    Russian) Smallest solid square, hollow square or tube of a mast that is clamped at its foot and carries the blocks
    of skyline and mainline, by stress under axial force and bending. Leaves out guylines, buckling, local buckling, own
    weight, wind, dynamics and fatigue.

    skyline_force: N. largest force in the skyline (above 0 kN).
    mainline_force: N. largest force in the mainline (at least 0 kN).
    skyline_block_height: m. height of the skyline block above the clamp (above 0 m).
    mainline_block_height: m. height of the mainline block above the clamp; default: as the skyline's (above 0 m).
    block_friction: friction of the rope on the block; the paper: 0.10 to 0.16 (at least 0 and at most 0.5). Default:
        0.12.
    wrap: wrap angle on the block: 90 deg + alpha, or the paper's 120 deg for any alpha: `geometric`, `paper`. Default:
        geometric.
    paid_out_force: N. largest force of a rope while it is paid out, at which its brake slips; default: the full force
        (above 0 kN).
    branch_angle: rad. angle of the span side of the ropes below the horizontal, negative when it rises; or give span
        (at least -60 deg and at most 85 deg).
    span: the span, from which the branch angle follows; or give branch_angle.
    allowable_stress: Pa. allowable stress; or give steel and safety (above 0 MPa).
    steel: steel grade of the catalogue, EN 10210-1 S355H; with safety.
    safety: yield stress over allowable stress; by second order also what the ropes' forces are multiplied by (at least
        1).
    tube_ratio: inner over outer diameter of the tube (at least 0 and below 1). Default: 0.9.
    section: catalogue section to check, CHS 508x16; RHS about the strong axis.
    choose_section: which catalogue sections may be chosen; or give section.
    guys: guylines, for the exact solution; not in the published method.
    lateral_force: N. horizontal force normal to the span at the skyline block, to the left when looking towards the
        span, for the exact solution: haulback rope, wind.
    base: foot of the mast in the exact solution; hinged needs guys: `clamped`, `hinged`. Default: clamped.
    checks: the block `checks` of the deck.
    design: the block `design` of the deck.
    title: title of the report.
    display: units of print by kind of quantity: {'force': 'kN'}.
    progress: called with what, part done (0 to 1), words; a returned False ends it.

    A number is SI, a text has its unit. Raises DeckError for mistakes; Interrupted after Ctrl-C, with what was done.
    """
def closed_loop(
    *,
    span: Quantity,
    gathering_force: Quantity,
    gathering_angle: Quantity,
    tail_efficiency: Quantity,
    slope: Quantity | None = None,
    height_difference: Quantity | None = None,
    position: Quantity | Sequence[Quantity] | None = None,
    mode: Literal["sag", "winch_pull", "loop_length", "free_running"] | None = None,
    sag: Quantity | None = None,
    winch_pull: Quantity | None = None,
    head_efficiency: Quantity | None = None,
    loop_length: Quantity | None = None,
    gathering_angle_from: Literal["vertical", "horizontal"] | None = None,
    return_weight: Quantity | None = None,
    traction_weight: Quantity | None = None,
    return_rope: str | Quantity | None = None,
    traction_rope: str | Quantity | None = None,
    tail_sheaves: int | None = None,
    carriage: Literal["single", "two_section"] | None = None,
    section_distance: Quantity | None = None,
    distance_kind: Literal["horizontal", "rope"] | None = None,
    sag_of: Literal["first", "second"] | None = None,
    position_of: Literal["first", "second"] | None = None,
    branch_distance: Quantity | None = None,
    branch_offset: Literal["normal", "vertical"] | None = None,
    carriage_weight: Quantity | None = None,
    return_stiffness: Quantity | None = None,
    traction_stiffness: Quantity | None = None,
    roller: Literal["free", "vertical"] | None = None,
    haul: Literal["in", "out"] | None = None,
    safety_factor: Quantity | None = None,
    wire_strength: Quantity | None = None,
    weight_per_area: Quantity | None = None,
    choose_ropes: Mapping[str, Any] | None = None,
    clearance: Quantity | None = None,
    checks: Mapping[str, Any] | None = None,
    design: Mapping[str, Any] | None = None,
    title: str | None = None,
    display: Mapping[str, str] | None = None,
    progress: Progress | None = None,
) -> Result:
    """Closed loop of two ropes with jointly loaded branches.

    V. D. Martynikhin: Raschet tyagovo-nesushchikh kanatov s parallelnymi sovmestno nagruzhennymi vetvyami,
    obrazuyushchimi zamknutyi kontur (Design of traction-carrying ropes with parallel, jointly loaded branches that form
    a closed loop), about 1971, in Russian Statics of a yarding line whose return rope is led back over the tail sheave,
    so that its upper branch carries part of the load: load share of the branches, tensions, rope areas, single and two-
    section carriage, in-haul and out-haul. The closed-form tier (parabolas, roller normal to the rope, true end
    tensions) stands beside the paper's formulas. Not modelled: rolling resistance, bending stiffness of the rope,
    branches that are not parallel, a rigid carriage, bending over sheaves, splices and wear, several spans (use the
    product of efficiencies as an estimate), dynamics, wind, temperature. Exact elastic catenaries of the same loop are
    given too.

    span: m. horizontal distance of the supports A (winch) and B (tail sheave) (above 0 m).
    gathering_force: N. force in the gathering line (above 0 kN).
    gathering_angle: rad. angle of the gathering line, down and toward B, measured from the line that
        gathering_angle_from names (at least 0 deg and at most 90 deg).
    tail_efficiency: efficiency of one sheave at B (above 0 and at most 1).
    slope: rad. slope of the chord from A to B; + when B is higher (downhill work) (above -60 deg and below 60 deg).
        Default: 0 deg.
    height_difference: m. height of B above A, in place of slope (negative when B is lower).
    position: m. horizontal distance from A to the carriage, one or a list; default: midspan (above 0 m).
    mode: what is given: the sag, the winch pull, the length of the loop, or that the return rope runs freely at the
        carriage: `sag`, `winch_pull`, `loop_length`, `free_running`. Default: sag.
    sag: m. vertical sag of the lower branch at the carriage, under the chord (above 0 m).
    winch_pull: N. pull of the winch on the traction rope (mode winch_pull) (above 0 kN).
    head_efficiency: efficiency of the traction rope's sheaves at A: T_lA = winch_pull * head_efficiency hauled in,
        winch_pull / head_efficiency hauled out (above 0 and at most 1). Default: 1.
    loop_length: m. unstretched length of the whole loop (mode loop_length) (above 0 m).
    gathering_angle_from: line from which gathering_angle is measured: `vertical`, `horizontal`. Default: vertical.
    return_weight: N/m. weight of the return rope per metre of rope (above 0 N/m).
    traction_weight: N/m. weight of the traction rope per metre of rope (above 0 N/m).
    return_rope: return rope of the catalogue, by id or by its properties, 6x36-IWRC 16 mm 1960 MPa; in place of
        return_weight.
    traction_rope: traction rope of the catalogue, by id or by its properties; in place of traction_weight.
    tail_sheaves: number of such sheaves at B, one after the other (at least 1 and at most 20). Default: 1.
    carriage: single, or two_section: rollers and clamp ahead, the gathering line on a second section behind them:
        `single`, `two_section`. Default: single.
    section_distance: m. distance of the two sections (above 0 m).
    distance_kind: section_distance is a horizontal distance, or the length of the rope between the sections:
        `horizontal`, `rope`. Default: horizontal.
    sag_of: the section at which sag is given: `first`, `second`. Default: first.
    position_of: the section at which position is given: `first`, `second`. Default: first.
    branch_distance: m. distance of the upper branch from the lower one (at least 0 m). Default: 0 m.
    branch_offset: direction of that distance: normal to the chord, or vertical: `normal`, `vertical`. Default: normal.
    carriage_weight: N. weight of the carriage (at least 0 kN). Default: 0 kN.
    return_stiffness: N. tensile stiffness EA of the return rope (above 0 kN). Default: .inf.
    traction_stiffness: N. tensile stiffness EA of the traction rope (above 0 kN). Default: .inf.
    roller: free: the roller force is normal to the rope; vertical: it is vertical, as in the paper: `free`, `vertical`.
        Default: free.
    haul: in: T_uB = eta T_lB, the load moves to the winch; out: the opposite: `in`, `out`. Default: in.
    safety_factor: least breaking force / largest tension; it has no default (above 1).
    wire_strength: Pa. minimum breaking force / metallic area of the rope (not the wire grade) (above 0 MPa).
    weight_per_area: N/m^3. rope weight per metre and metallic area; the paper's 0.01 kgf/(m mm^2) (above 0 N/m^3).
        Default: 98066 N/m^3.
    choose_ropes: chooses the smallest catalogue ropes that pass safety_factor with their own weight.
    clearance: m. largest sag that the ground allows at the carriage (above 0 m).
    checks: the block `checks` of the deck.
    design: the block `design` of the deck.
    title: title of the report.
    display: units of print by kind of quantity: {'force': 'kN'}.
    progress: called with what, part done (0 to 1), words; a returned False ends it.

    A number is SI, a text has its unit. Raises DeckError for mistakes; Interrupted after Ctrl-C, with what was done.
    """
def friction_drive(
    *,
    cutting_force: Quantity,
    friction: Quantity,
    wrap: Quantity,
    rope_mass: Quantity,
    speed: Quantity,
    grip_reserve: Quantity | None = None,
    section_factor: Quantity | None = None,
    fill_ratio: Quantity | None = None,
    rest_arc: Quantity | None = None,
    idler_loss: Quantity | None = None,
    rope_area: Quantity | None = None,
    sheave_radius: Quantity | None = None,
    rope: str | Quantity | None = None,
    take_up: Mapping[str, Any] | None = None,
    rope_stiffness: Quantity | None = None,
    centre_distance: Quantity | None = None,
    idler_radius: Quantity | None = None,
    cut: Literal["at_idler", "in_tight_branch"] | None = None,
    checks: Mapping[str, Any] | None = None,
    design: Mapping[str, Any] | None = None,
    title: str | None = None,
    display: Mapping[str, str] | None = None,
    progress: Progress | None = None,
) -> Result:
    """Initial tension of a rope-saw and of friction drives in general.

    P. B. Ryabukhin, I. V. Grigoriev, V. A. Ivanov: Calculation method of the initial tension of the flexible cutting
    tool of the saw unit for group bucking. Systems. Methods. Technologies, 2022, no. 2, pp. 48-54, doi
    10.18324/2077-5415-2022-2-48-54 (in Russian) Branch forces of an endless rope on a driving sheave and an idler
    pulled by a constant force, with centrifugal tension, idler loss and Andreev's working arc; the paper's initial
    tension and the pull that keeps the rope from slipping.

    cutting_force: N. cutting force on the rope (above 0 kN).
    friction: friction of the rope on the driving sheave; a warning above 0.4 (above 0 and at most 1.5).
    wrap: rad. wrap angle on the driving sheave (above 0 deg and at most 5729.6 deg).
    rope_mass: kg/m. mass per metre of the rope with its cutters (at least 0 kg/m).
    speed: m/s. speed of the rope (at least 0 m/s).
    grip_reserve: reliability factor of grip (at least 1). Default: 1.2.
    section_factor: k = (1 - nu) S_x^2 / (I_x F) of Andreev's formula; readings: 0.126 or 0.56 for a solid round (at
        least 0 and at most 1). Default: 0.
    fill_ratio: fill factor of the rope over the largest of its family (at least 0 and at most 1). Default: 1.
    rest_arc: rad. arc of rest m_a d/R, subtracted from the wrap (at least 0 deg). Default: 0 deg.
    idler_loss: factor of idler and bearing losses in (14) (at least 1). Default: 1.08.
    rope_area: m^2. metallic area of the rope; default: that of `rope` (above 0 mm^2).
    sheave_radius: m. radius of the driving sheave to the rope's centre (above 0 m).
    rope: rope of the catalogue, by id or in words: "6x36-IWRC 16 mm 1960 MPa"; for stress, D/d, safety factor.
    take_up: take-up, for the exact solution; default: takeup_with_idler_loss of the method.
    rope_stiffness: N. stiffness EA, for the creep; default: 100 GPa times the area (above 0 kN).
    centre_distance: m. distance of driving sheave and idler, for the length of the rope with a screw; with
        sheave_radius the arcs count too (above 0 m).
    idler_radius: m. radius of the idler to the rope's centre: `checks` need it for D/d, groove pressure and life (above
        0 m).
    cut: place of the cutting force in the exact solution: at_idler (the idler feels the whole tight tension, as in the
        method), or in the middle of the tight branch: `at_idler`, `in_tight_branch`. Default: at_idler.
    checks: the block `checks` of the deck.
    design: the block `design` of the deck.
    title: title of the report.
    display: units of print by kind of quantity: {'force': 'kN'}.
    progress: called with what, part done (0 to 1), words; a returned False ends it.

    A number is SI, a text has its unit. Raises DeckError for mistakes; Interrupted after Ctrl-C, with what was done.
    """
def boom_ropes(
    *,
    section_weight: Quantity,
    pad_friction: Quantity,
    tackle_efficiency: Quantity,
    extension_stiffness: Quantity,
    retraction_stiffness: Quantity,
    tensioned_last: Literal["extension", "retraction"] | None = None,
    tensioning_steps: int | None = None,
    slip_friction: Quantity | None = None,
    S10: Quantity | None = None,
    S20: Quantity | None = None,
    stiffness_ratio: Quantity | None = None,
    cases: Sequence[Mapping[str, Any] | str] | None = None,
    sliding: Mapping[str, Any] | None = None,
    checks: Mapping[str, Any] | None = None,
    design: Mapping[str, Any] | None = None,
    title: str | None = None,
    display: Mapping[str, str] | None = None,
    progress: Progress | None = None,
) -> Result:
    """Extension and retraction ropes of a three-section telescopic boom.

    A. A. Reutov, Calculating and modeling rope mechanism of a mobile crane telescopic boom, 2021, no. 1, pp. 13-22, DOI
    10.30987/2658-6436-2021-1-13-22 Rope tensions of section 3 by (1)-(5), least pretensions, alternating tensioning
    (Table 1); with the block sliding also rope, pad and cylinder forces while sections 2 and 3 slide, jamming included.
    Statics in the luffing plane: no inertia, no swinging load, no rope dynamics.

    section_weight: N. weight of section 3 (above 0 kN).
    pad_friction: friction coefficient of the pads (at least 0).
    tackle_efficiency: efficiency of the hoist tackle (above 0 and at most 1).
    extension_stiffness: N/m. stiffness of half of the extension rope (above 0 MN/m).
    retraction_stiffness: N/m. stiffness of the retraction rope (above 0 MN/m).
    tensioned_last: rope that was tensioned last: `extension`, `retraction`. Default: extension.
    tensioning_steps: steps of the alternating tensioning (at least 0 and at most 1000). Default: 4.
    slip_friction: static friction of the pads, for slip angles (at least 0). Default: 0.155.
    S10: N. pretension of the extension rope (one branch), checked against (3); default: that of 'sliding' (at least 0
        kN).
    S20: N. pretension of the retraction rope, checked against (3); default: that of 'sliding' (at least 0 kN).
    stiffness_ratio: C_2/C_1 as measured (fall of S_2 per rise of S_1), for the corrected stiffness (above 0).
    cases: load cases for which the ropes are tensioned.
    sliding: quasi-static model of sections 2 and 3 sliding on their pads.
    checks: the block `checks` of the deck.
    design: the block `design` of the deck.
    title: title of the report.
    display: units of print by kind of quantity: {'force': 'kN'}.
    progress: called with what, part done (0 to 1), words; a returned False ends it.

    A number is SI, a text has its unit. Raises DeckError for mistakes; Interrupted after Ctrl-C, with what was done.
    """
