"""Made from the descriptions by python/tools/make_stub.py; do not edit. `./dev python stub` makes it again.

schema: aae8f5e1c103c7bb24225c0a0a7f5313f4e7d0590ea7d9aa9152a804c14c4427
"""

from collections.abc import Mapping, Sequence
from typing import Any, Literal

from ._machine import Machine
from ._units import Quantity

class Parts:
    def point(
        self,
        name: str,
        at: Sequence[Quantity] | Mapping[str, Any],
        *,
        body: str | Quantity | None = None,
    ) -> Machine:
        """Adds one to `points`: points of the ground or of a body.

        at: m. place in the frame of its body, or of the ground (at least -1e7 m and at most 1e7 m).
        body: the body to which it belongs; default: the ground.

        A number is SI, a text has its unit. Returns the machine; its mistakes are told when it is calculated.
        """
    def rope(
        self,
        name: str,
        rope: str | Quantity | None = None,
        *,
        mass: Quantity | None = None,
        stiffness: Quantity | None = None,
        breaking_force: Quantity | None = None,
        diameter: Quantity | None = None,
        expansion: Quantity | None = None,
        reference_temperature: Quantity | None = None,
        damping_ratio: Quantity | None = None,
        damping_time: Quantity | None = None,
    ) -> Machine:
        """Adds one to `ropes`: properties of ropes.

        rope: id in the catalogue of ropes, as 'taut list ropes' shows it, or the properties of one of its ropes: '6x36-IWRC
            20 mm 1960 MPa'.
        mass: kg/m. mass per unstretched metre (at least 0 kg/m and at most 1e9 kg/m).
        stiffness: N. axial stiffness EA; default for a rope of the catalogue: metallic area times a modulus by
            construction; .inf: inextensible (above 0 MN).
        breaking_force: N. minimum breaking force (above 0 kN).
        diameter: m. nominal diameter (above 0 mm and at most 1e10 mm).
        expansion: 1/K. thermal expansion (at least -0.0001 1/K and at most 0.0001 1/K). Default: 1.2e-5 1/K.
        reference_temperature: K. temperature at which lengths are given; default: that of the machine (at least -273.15
            degC and at most 1726.8 degC).
        damping_ratio: damping ratio of the lowest mode that stretches it; used in motion only (at least 0).
        damping_time: s. T = EA (e + beta e'); used in motion only (at least 0 s).

        A number is SI, a text has its unit. Returns the machine; its mistakes are told when it is calculated.
        """
    def body(
        self,
        name: str,
        at: Sequence[Quantity] | Mapping[str, Any] | None = None,
        mass: Quantity | None = None,
        free: Sequence[Literal["x", "y", "z", "rx", "ry", "rz"]] | None = None,
        *,
        centre: Sequence[Quantity] | Mapping[str, Any] | None = None,
        guide: Sequence[Quantity] | Mapping[str, Any] | None = None,
        inertia: Quantity | Sequence[Quantity] | None = None,
        motion: Mapping[str, Any] | None = None,
        turned: Mapping[str, Any] | None = None,
        on: str | Quantity | None = None,
    ) -> Machine:
        """Adds one to `bodies`: rigid bodies.

        at: m. place of its origin; of a free body a first guess (at least -1e7 m and at most 1e7 m).
        mass: kg. mass; its weight acts at the centre of mass (at least 0 kg and at most 1e9 kg). Default: 0 kg.
        free: degrees of freedom along and about the axes of the ground, of a body 'on' another along and about those of
            that one at the start; none: fixed: `x`, `y`, `z`, `rx`, `ry`, `rz`.
        centre: m. centre of mass relative to the origin; default: there (at least -1e7 m and at most 1e7 m).
        guide: direction of its only translation, a slide.
        inertia: kg m^2. about the centre of mass: one for all axes, or Ixx, Iyy, Izz; used in motion only (at least 0 kg
            m^2).
        motion: given motion; statics takes its place at the start.
        turned: rotations about the axes of the ground at the start, right-handed; of a free body a first guess.
        on: the body in whose frame at the start its place, axes, freedoms and guide are given; default: the ground.

        A number is SI, a text has its unit. Returns the machine; its mistakes are told when it is calculated.
        """
    def sheave(
        self,
        name: str,
        at: Sequence[Quantity] | Mapping[str, Any],
        diameter: Quantity | None = None,
        efficiency: Quantity | None = None,
        body: str | Quantity | None = None,
        *,
        axis: Sequence[Quantity] | Mapping[str, Any] | None = None,
        law: Literal["sheave", "saddle"] | None = None,
        friction: Quantity | None = None,
        uplift: Literal["hold", "report", "lift"] | None = None,
        inertia: Quantity | None = None,
        drag: Quantity | None = None,
        holds: str | Quantity | None = None,
        one_wheel: bool | None = None,
        motor: Mapping[str, Any] | None = None,
    ) -> Machine:
        """Adds one to `sheaves`: sheaves and saddles.

        at: m. centre, in the frame of its body, or of the ground (at least -1e7 m and at most 1e7 m).
        diameter: m. pitch diameter, to the centre of the rope; 0: a point (at least 0 mm and at most 1e10 mm). Default: 0
            mm.
        efficiency: T_small/T_large over the turning sheave (above 0 and at most 1). Default: 1.
        body: the body that carries it; default: the ground.
        axis: direction of its axis, in the frame of its body; default: [0, 1, 0], on the ground across the line in plan.
        law: a sheave turns (default in sheaves), a saddle does not (default in supports): `sheave`, `saddle`.
        friction: friction coefficient of the rope in the groove; on a sheave without it the rope does not slip (at least
            0).
        uplift: where the rope pulls upwards: hold it (default of a sheave), report it (default of a saddle), or let it lift
            off: `hold`, `report`, `lift`.
        inertia: kg m^2. moment of inertia; used in motion only; default: none (at least 0 kg m^2).
        drag: N m s. viscous drag of its turning: moment by angular velocity; used in motion only, with an 'inertia' (at
            least 0 N m s and at most 1e12 N m s). Default: 0 N m s.
        holds: 'ahead_of CARRIAGE': it holds a rope that ends at this carriage only while the carriage has not passed it;
            default: always.
        one_wheel: true: one wheel with a groove for each rope, and each turn of one, that runs over it; default: sheaves
            beside each other that turn by themselves, each with the inertia and drag, one for each of the 'copies' of a
            rope too; a driven sheave is always one wheel. Default: false.
        motor: the sheave drives its rope.

        A number is SI, a text has its unit. Returns the machine; its mistakes are told when it is calculated.
        """
    def saddle(
        self,
        name: str,
        at: Sequence[Quantity] | Mapping[str, Any],
        friction: Quantity | None = None,
        diameter: Quantity | None = None,
        *,
        body: str | Quantity | None = None,
        axis: Sequence[Quantity] | Mapping[str, Any] | None = None,
        law: Literal["sheave", "saddle"] | None = None,
        efficiency: Quantity | None = None,
        uplift: Literal["hold", "report", "lift"] | None = None,
        inertia: Quantity | None = None,
        drag: Quantity | None = None,
        holds: str | Quantity | None = None,
        one_wheel: bool | None = None,
        motor: Mapping[str, Any] | None = None,
    ) -> Machine:
        """Adds one to `supports`: supports of a standing line: saddles.

        at: m. centre, in the frame of its body, or of the ground (at least -1e7 m and at most 1e7 m).
        friction: friction coefficient of the rope in the groove; on a sheave without it the rope does not slip (at least
            0).
        diameter: m. pitch diameter, to the centre of the rope; 0: a point (at least 0 mm and at most 1e10 mm). Default: 0
            mm.
        body: the body that carries it; default: the ground.
        axis: direction of its axis, in the frame of its body; default: [0, 1, 0], on the ground across the line in plan.
        law: a sheave turns (default in sheaves), a saddle does not (default in supports): `sheave`, `saddle`.
        efficiency: T_small/T_large over the turning sheave (above 0 and at most 1). Default: 1.
        uplift: where the rope pulls upwards: hold it (default of a sheave), report it (default of a saddle), or let it lift
            off: `hold`, `report`, `lift`.
        inertia: kg m^2. moment of inertia; used in motion only; default: none (at least 0 kg m^2).
        drag: N m s. viscous drag of its turning: moment by angular velocity; used in motion only, with an 'inertia' (at
            least 0 N m s and at most 1e12 N m s). Default: 0 N m s.
        holds: 'ahead_of CARRIAGE': it holds a rope that ends at this carriage only while the carriage has not passed it;
            default: always.
        one_wheel: true: one wheel with a groove for each rope, and each turn of one, that runs over it; default: sheaves
            beside each other that turn by themselves, each with the inertia and drag, one for each of the 'copies' of a
            rope too; a driven sheave is always one wheel. Default: false.
        motor: the sheave drives its rope.

        A number is SI, a text has its unit. Returns the machine; its mistakes are told when it is calculated.
        """
    def drum(
        self,
        name: str,
        at: Sequence[Quantity] | Mapping[str, Any],
        core_diameter: Quantity | None = None,
        *,
        body: str | Quantity | None = None,
        axis: Sequence[Quantity] | Mapping[str, Any] | None = None,
        layer: int | None = None,
        drive: Mapping[str, Any] | None = None,
        layers: Literal["auto"] | None = None,
        length_on_drum: Quantity | None = None,
        wound_at: Quantity | None = None,
        face_width: Quantity | None = None,
        flange_diameter: Quantity | None = None,
        pitch: Quantity | None = None,
        layer_height: Quantity | None = None,
        inertia: Quantity | None = None,
        drag: Quantity | None = None,
        brake_torque: Quantity | None = None,
        brake_delay: Quantity | None = None,
        brake_rise: Quantity | None = None,
    ) -> Machine:
        """Adds one to `drums`: winch drums.

        at: m. centre, in the frame of its body, or of the ground (at least -1e7 m and at most 1e7 m).
        core_diameter: m. diameter of the bare drum; 0: a point (at least 0 mm and at most 1e10 mm). Default: 0 mm.
        body: the body that carries it; default: the ground.
        axis: direction of its axis, in the frame of its body; default: [0, 1, 0].
        layer: the layer from which the rope leaves; default: the first (at least 1).
        drive: drive; without it the drum does not turn.
        layers: the layer follows from the length on the drum: `auto`.
        length_on_drum: m. unstretched rope on the drum, of each rope and copy that winds on it (at least 0 m and at most
            1e7 m).
        wound_at: N. winding tension of the rope on the drum; default: 0, in motion the tension at the start (at least 0 kN
            and at most 1e9 kN).
        face_width: m. width between the flanges (above 0 mm and at most 1e10 mm).
        flange_diameter: m. flange diameter, which limits the layers (above 0 mm and at most 1e10 mm).
        pitch: m. distance from wrap to wrap; default: the rope diameter (above 0 mm and at most 1e10 mm).
        layer_height: m. distance from layer to layer; default: the rope diameter (above 0 mm and at most 1e10 mm).
        inertia: kg m^2. moment of inertia of everything that turns with it; used in motion only (at least 0 kg m^2).
            Default: 0 kg m^2.
        drag: N m s. viscous drag of its turning: moment by angular velocity; used in motion only, with an 'inertia' (at
            least 0 N m s and at most 1e12 N m s). Default: 0 N m s.
        brake_torque: N m. moment above which the drum turns in its brake: in motion, and as a check at rest; default: it
            holds anything (above 0 kN m and at most 1e9 kN m).
        brake_delay: s. time from setting the brake until it begins to act (at least 0 s and at most 3600 s). Default: 0 s.
        brake_rise: s. time in which its moment then grows to the full one (at least 0 s and at most 3600 s). Default: 0 s.

        A number is SI, a text has its unit. Returns the machine; its mistakes are told when it is calculated.
        """
    def carriage(
        self,
        name: str,
        mass: Quantity | None = None,
        rides: str | Quantity | None = None,
        mainline: str | Quantity | None = None,
        *,
        carriage: str | Quantity | None = None,
        catalogue: str | Quantity | None = None,
        hold: Literal["rolling", "clamped", "fixed_to"] | None = None,
        fixed_to: str | Quantity | None = None,
        haulback: str | Quantity | None = None,
        friction: Quantity | None = None,
        length_before: Quantity | None = None,
        at: Sequence[Quantity] | Mapping[str, Any] | None = None,
        rollers: int | None = None,
        wheelbase: Quantity | None = None,
        inertia: Quantity | None = None,
        height: Quantity | None = None,
        rated_payload: Quantity | None = None,
        rope_diameters: Quantity | Sequence[Quantity] | None = None,
    ) -> Machine:
        """Adds one to `carriages`: carriages on a rope.

        mass: kg. mass (at least 0 kg and at most 1e9 kg). Default: 0 kg.
        rides: the reeving it rides on.
        mainline: the reeving whose length determines its place in a load path.
        carriage: a carriage by its name in the catalogue (taut list carriages): mass, rated payload, rope diameters,
            rollers and wheelbase, where the deck does not give them.
        catalogue: a file of carriages (CSV) in place of the built-in ones, beside the deck.
        hold: rolling on the rope, clamped to it, or rolling on it and fixed to a second, running rope: `rolling`,
            `clamped`, `fixed_to`. Default: rolling.
        fixed_to: the second reeving, to which it is fixed; its path has the carriage too.
        haulback: the reeving that pulls it against the mainline.
        friction: rolling friction on the rope (at least 0). Default: 0.
        length_before: m. clamped or fixed: unstretched length from the start of that reeving (closed: from its drive) to
            the clamp (above 0 m and at most 1e7 m).
        at: m. a first guess of its place (at least -1e7 m and at most 1e7 m).
        rollers: number of rollers, at equal distances; with more than one the carriage pitches (at least 1 and at most 16).
            Default: 1.
        wheelbase: m. distance from the first roller to the last (above 0 m and at most 100 m).
        inertia: kg m^2. moment of inertia of a carriage that pitches, about its centre of mass; used in motion only (at
            least 0 kg m^2). Default: 0 kg m^2.
        height: m. height of the rollers above the origin of the carriage, at which its mass, loads and ropes act; the
            carriage then swings (at least 0 m and at most 100 m). Default: 0 m.
        rated_payload: kg. largest load on it: checked in every state, and a limit of each payload analysis (above 0 kg and
            at most 1e9 kg).
        rope_diameters: m. least and largest diameter of the rope on which it rides: checked (above 0 mm and at most 1000
            mm).

        A number is SI, a text has its unit. Returns the machine; its mistakes are told when it is calculated.
        """
    def reeve(
        self,
        rope: str | Quantity,
        path: Sequence[Mapping[str, Any] | str],
        *,
        name: str | Quantity | None = None,
        length: Quantity | None = None,
        tension_at_start: Quantity | None = None,
        tension_at_end: Quantity | None = None,
        tension_equals: str | Quantity | None = None,
        install: Mapping[str, Any] | None = None,
        copies: int | None = None,
        haul: Literal["to_start", "to_end"] | None = None,
        segments: int | None = None,
        may_slack: bool | None = None,
        closed: bool | None = None,
    ) -> Machine:
        """Adds one to `reevings`: paths of the ropes.

        rope: one of the ropes.
        path: elements from end to end.
        name: name in tables and references; default: the name of the rope.
        length: m. unstretched length of the rope from end to end (above 0 m and at most 1e7 m).
        tension_at_start: N. in place of the length: tension that is constant in every state at rest, as by a counterweight;
            a motion begins with it and keeps the length (above 0 kN and at most 1e9 kN).
        tension_at_end: N. in place of the length: tension that is constant in every state at rest, as by a counterweight; a
            motion begins with it and keeps the length (above 0 kN and at most 1e9 kN).
        tension_equals: in place of the length: a rope; at rest as described both have the same tension at the start of
            their paths, and the length found there is kept.
        install: in place of the length: tension when the line is put up; the length found there is kept.
        copies: number of equal parallel ropes (at least 1). Default: 1.
        haul: direction when hoisting or hauling in; default: to its drum or given tension, a mainline or haulback off from
            its carriage, others as these draw them along: `to_start`, `to_end`.
        segments: in motion the number of segments of each branch, with the mass of the rope at their joints, which may run
            over rounds and onto drums (at least 1 and at most 1000). Default: 1.
        may_slack: true: it may go slack without an unsafe warning. Default: false.
        closed: an endless rope, from the last element back to the first. Default: false.

        A number is SI, a text has its unit. Returns the machine; its mistakes are told when it is calculated.
        """
    def load(
        self,
        at: str | Quantity,
        mass: Quantity | None = None,
        *,
        name: str | Quantity | None = None,
        force: Sequence[Quantity] | Mapping[str, Any] | None = None,
        signal: str | Quantity | None = None,
        dragged: Mapping[str, Any] | None = None,
    ) -> Machine:
        """Adds one to `loads`: weights and forces of constant direction.

        at: a body, a carriage, or a point or sheave on one.
        mass: kg. mass; its weight acts downwards (at least 0 kg and at most 1e9 kg).
        name: name for paths and for 'with'.
        force: N. force in the ground frame (at least -1e9 kN and at most 1e9 kN).
        signal: in motion the size of the force over time, in the direction of 'force': a signal; statics takes 'force'.
        dragged: the mass is a bunch of logs that drags one end over the ground.
        Give exactly one of mass, force.

        A number is SI, a text has its unit. Returns the machine; its mistakes are told when it is calculated.
        """
    def rope_load(
        self,
        *,
        rope: str | Quantity,
        between: str | Sequence[str],
        tangential: Quantity | None = None,
        rate: Quantity | None = None,
        direction: Literal["against_motion", "with_motion", "along_path", "against_path"] | None = None,
        position: Quantity | None = None,
        from_: Quantity | None = None,
        to: Quantity | None = None,
        elements: int | None = None,
        signal: str | Quantity | None = None,
        name: str | Quantity | None = None,
    ) -> Machine:
        """Adds one to `rope_loads`: forces along a branch of a rope.

        rope: the reeving on which it acts.
        between: two neighbours of its path, the ends of the branch.
        tangential: N. force along the rope, in statics; without it and 'rate' the force that balances the motor's torque
            (at least 0 kN and at most 1e9 kN).
        rate: N/m. force per unstretched metre, over a part of the branch (at least 0 N/m and at most 1e12 N/m).
        direction: direction of the force on the rope; at rest the motion is 'in': `against_motion`, `with_motion`,
            `along_path`, `against_path`. Default: against_motion.
        position: place as a fraction of the unstretched branch, from the first of 'between'; default: 0.5 (above 0 and
            below 1).
        from_: fraction at which a rate begins; default: 0 (at least 0 and at most 1).
        to: fraction at which a rate ends; default: 1 (at least 0 and at most 1).
        elements: number of parts into which a rate is divided; default: up to 16 (at least 1 and at most 64).
        signal: in motion the force, or the rate, over time: a signal, whose sign does not count against the motion; statics
            takes 'tangential' or 'rate'.
        name: name in tables; default: ROPE.load.

        A number is SI, a text has its unit. Returns the machine; its mistakes are told when it is calculated.
        """
    def take_up(
        self,
        *,
        body: str | Quantity,
        weight: Quantity | None = None,
        screw: Quantity | None = None,
        keeps: Literal["place", "force"] | None = None,
        along: Sequence[Quantity] | Mapping[str, Any] | None = None,
    ) -> Machine:
        """Adds one to `take_up`: weights and screws that tighten ropes.

        body: the body that is pulled.
        weight: kg. a counterweight of this mass on a rope without loss (at least 0 kg and at most 1e9 kg).
        screw: N. its force; in which states, 'keeps' says (at least 0 kN and at most 1e9 kN).
        keeps: of a screw: its place, where it pulls with its force at rest without the machine's loads; or its force in
            every state, as a ram does. Default: its force, and the machine is not judged: `place`, `force`.
        along: direction of its pull, in the ground frame.
        Give exactly one of weight, screw.

        A number is SI, a text has its unit. Returns the machine; its mistakes are told when it is calculated.
        """
    def guy(
        self,
        name: str,
        rope: str | Quantity,
        from_: str | Quantity,
        to: str | Quantity,
        *,
        install: Mapping[str, Any] | None = None,
        length: Quantity | None = None,
    ) -> Machine:
        """Adds one to `guys`: ropes between two anchors, put up by tension or length.

        rope: one of the ropes.
        from_: upper end: a point, body, carriage or centre of a sheave.
        to: lower end, its anchor.
        install: tension when it is put up.
        length: m. unstretched length (above 0 m and at most 1e7 m).
        Give exactly one of install, length.

        A number is SI, a text has its unit. Returns the machine; its mistakes are told when it is calculated.
        """
    def beam(
        self,
        name: str,
        *,
        from_: str | Quantity,
        to: str | Quantity,
        section: str | Quantity | None = None,
        A: Quantity | None = None,
        I: Quantity | None = None,
        I_weak: Quantity | None = None,
        J: Quantity | None = None,
        W_t: Quantity | None = None,
        round: bool | None = None,
        W: Quantity | None = None,
        W_weak: Quantity | None = None,
        E: Quantity | None = None,
        mass: Quantity | None = None,
        steel: str | Quantity | None = None,
        expansion: Quantity | None = None,
        reference_temperature: Quantity | None = None,
        strong: Sequence[Quantity] | Mapping[str, Any] | None = None,
        elements: int | None = None,
        base: Literal["clamped", "hinge"] | None = None,
        top: Literal["free", "clamped", "hinge"] | None = None,
        order: Literal["second", "first"] | None = None,
        imperfection: Mapping[str, Any] | Quantity | Sequence[Any] | None = None,
    ) -> Machine:
        """Adds one to `beams`: elastic struts and masts.

        from_: its base: a point, a body's origin, or another beam's top.
        to: its other end: a point of the ground (place of the free top as built), or a point of a body to which it is
            joined.
        section: section of the catalogue, as 'taut list sections' shows it.
        A: m^2. area of the section, in place of a section of the catalogue (above 0 cm^2 and at most 1000000 cm^2).
        I: m^4. second moment of area, for bending towards 'strong' (above 0 cm^4 and at most 1e10 cm^4).
        I_weak: m^4. second moment of area for the other direction; default: the same (above 0 cm^4 and at most 1e10 cm^4).
        J: m^4. torsion constant; default: I + I_weak, as of a round tube (above 0 cm^4 and at most 1e10 cm^4).
        W_t: m^3. elastic torsion modulus, for the stress: torsion over it is the largest shear stress; default: not known,
            of a round section 2 W (above 0 cm^3 and at most 1e8 cm^3).
        round: true: a section by figures that is round, so that both bending moments add as vectors; default: of a box
            where 'strong', 'I_weak' or 'W_weak' is given, else not known. Default: false.
        W: m^3. elastic section modulus, for the stress (above 0 cm^3 and at most 1e8 cm^3).
        W_weak: m^3. elastic section modulus for the other direction; default: the same (above 0 cm^3 and at most 1e8 cm^3).
        E: Pa. modulus of elasticity; G = E/2.6 (above 0 GPa and at most 10000 GPa). Default: 210 GPa.
        mass: kg/m. mass per metre; default: that of the catalogue, or A times 7850 kg/m3 (at least 0 kg/m and at most
            1000000 kg/m).
        steel: steel grade, for the check of the stress, as 'taut list steels' shows it.
        expansion: 1/K. thermal expansion (EN 1993-1-1, 3.2.6) (at least 0 1/K and at most 0.0001 1/K). Default: 1.2e-5 1/K.
        reference_temperature: K. temperature at which it reaches from 'from' to 'to' without stress; default: that of the
            machine (at least -273.15 degC and at most 1726.8 degC).
        strong: direction of bending about its strong axis; default: upwards for a horizontal beam, x for a vertical one.
        elements: number of intervals between the sections that tables show; the largest values are looked for at 48 or more
            (at least 1 and at most 256). Default: 16.
        base: connection at 'from'; a hinge inclines in any direction but does not turn about the axis of the beam:
            `clamped`, `hinge`. Default: clamped.
        top: connection at 'to'; default: free where 'to' is a point of the ground, else clamped: `free`, `clamped`,
            `hinge`.
        order: second: equilibrium of the deformed beam, any rotations; first: of the beam as built: `second`, `first`.
            Default: second.
        imperfection: initial imperfection, free of stress.
        Give exactly one of section, A.

        A number is SI, a text has its unit. Returns the machine; its mistakes are told when it is calculated.
        """
    def ground(
        self,
        x: Quantity | Sequence[Quantity] | None = None,
        z: Quantity | Sequence[Quantity] | None = None,
        *,
        file: str | Quantity | None = None,
        y: Quantity | Sequence[Quantity] | None = None,
        between: str | Sequence[str] | None = None,
        corridor: Quantity | None = None,
        from_: Quantity | Sequence[Quantity] | None = None,
        along: Quantity | Sequence[Quantity] | None = None,
    ) -> Machine:
        """Gives `terrain`: ground under the line.

        x: m. chainages, increasing; with 'y': x in the ground frame.
        z: m. height of the ground there.
        file: CSV in metres: columns chainage (or x) and z, chainage increasing; or x, y, z of a survey.
        y: m. of a survey: y in the ground frame; its rows are projected on the line.
        between: two points: the line runs from the first (chainage 0) to the second; default for a survey: from its first
            to its last row.
        corridor: m. a warning names surveyed rows, and ropes with a carriage, farther off the line than this; a clearance
            that is asked of such a rope is not judged (at least 0 m). Default: 5 m.
        from_: m. place with chainage 0, [x, y] in the ground frame; for lines oblique to the axes.
        along: horizontal direction of the chainage, [x, y].

        A number is SI, a text has its unit. Returns the machine; its mistakes are told when it is calculated.
        """
    def signal(
        self,
        name: str,
        *,
        constant: str | Quantity | None = None,
        ramp: Mapping[str, Any] | None = None,
        table: Mapping[str, Any] | None = None,
        sine: Mapping[str, Any] | None = None,
        sequence: Sequence[Mapping[str, Any] | str] | None = None,
        formula: str | Quantity | None = None,
    ) -> Machine:
        """Adds one to `signals`: quantities over time; a signal that no key uses has no effect.

        constant: a constant value, with its unit.
        ramp: from one value to another.
        table: values at given times.
        sine: mean + amplitude sin(2 pi f t + phase).
        sequence: changes one after the other, beginning from 0.
        formula: of the time t: numbers with their units, + - * / ^, pi, and the functions sqrt abs min max sin cos tan asin
            acos atan atan2: '0.5 m/s * sin(90 deg/s * t)'. Hz is 2 pi rad/s, no cycle more: 'sin(3 Hz * t)' swings 3 times
            a second, 'sin(2*pi*3 Hz * t)' 18.85 times.
        Give exactly one of constant, ramp, table, sine, sequence, formula.

        A number is SI, a text has its unit. Returns the machine; its mistakes are told when it is calculated.
        """
    def marker(
        self,
        name: str,
        *,
        at: Sequence[Quantity] | Mapping[str, Any],
        body: str | Quantity | None = None,
    ) -> Machine:
        """Adds one to `markers`: places on bodies, for contacts and observed quantities.

        at: m. place in the frame of its body, or of the ground (at least -1e7 m and at most 1e7 m).
        body: the body to which it belongs; default: the ground.

        A number is SI, a text has its unit. Returns the machine; its mistakes are told when it is calculated.
        """
    def face(
        self,
        name: str,
        *,
        from_: Sequence[Quantity] | Mapping[str, Any],
        to: Sequence[Quantity] | Mapping[str, Any],
        body: str | Quantity | None = None,
        normal: Sequence[Quantity] | Mapping[str, Any] | None = None,
    ) -> Machine:
        """Adds one to `faces`: plane faces of bodies, for contacts.

        from_: m. one end, in the frame of its body (at least -1e7 m and at most 1e7 m).
        to: m. the other end; there is no contact beyond the ends (at least -1e7 m and at most 1e7 m).
        body: the body to which it belongs; default: the ground.
        normal: direction out of the body, towards the points without contact; default: [0, 0, 1].

        A number is SI, a text has its unit. Returns the machine; its mistakes are told when it is calculated.
        """
    def contact(
        self,
        *,
        point: str | Quantity,
        face: str | Quantity,
        stiffness: Quantity,
        name: str | Quantity | None = None,
        damping: Quantity | None = None,
        tangential_stiffness: Quantity | None = None,
        tangential_damping: Quantity | None = None,
        clearance: Quantity | None = None,
        static_friction: Quantity | None = None,
        kinetic_friction: Quantity | None = None,
        stribeck_speed: Quantity | None = None,
    ) -> Machine:
        """Adds one to `contacts`: points of bodies on faces of others.

        point: a point or marker of one body.
        face: a face of another body.
        stiffness: N/m. stiffness normal to the face (above 0 N/m).
        name: name in tables; default: the name of its point.
        damping: N s/m. damping normal to the face, while in contact (at least 0 N s/m). Default: 0 N s/m.
        tangential_stiffness: N/m. stiffness along the face while it sticks; default: half of the stiffness (above 0 N/m).
        tangential_damping: N s/m. damping along the face while it sticks; default: half of the damping (at least 0 N s/m).
        clearance: m. gap that has to close first (at least 0 mm). Default: 0 mm.
        static_friction: static friction coefficient (at least 0). Default: 0.
        kinetic_friction: kinetic friction coefficient, of fast sliding; default: the static one (at least 0).
        stribeck_speed: m/s. sliding speed over which friction falls from static to kinetic; default: 0.01 m/s (above 0
            m/s).

        A number is SI, a text has its unit. Returns the machine; its mistakes are told when it is calculated.
        """
    def actuator(
        self,
        name: str,
        *,
        from_: str | Quantity,
        to: str | Quantity,
        force: str | Quantity | None = None,
        law: Mapping[str, Any] | None = None,
        speed: str | Quantity | None = None,
        mode: Literal["extend", "retract", "lock", "free"] | None = None,
        lock_stiffness: Quantity | None = None,
        lock_damping: Quantity | None = None,
        force_limit: Quantity | None = None,
    ) -> Machine:
        """Adds one to `actuators`: cylinders.

        from_: a point, marker or body.
        to: a point, marker or body.
        force: pushes the two apart: a signal, or a force.
        law: force F0 + gain (reference - speed).
        speed: speed at which the two move apart: a signal, or a speed.
        mode: retract: reference speed reversed, without F0; lock: constant length; free: no force. Locked or free, and set
            to nothing else by an event, it needs no force, law or speed: `extend`, `retract`, `lock`, `free`. Default:
            extend.
        lock_stiffness: N/m. stiffness while it is locked (above 0 N/m).
        lock_damping: N s/m. damping while it is locked; default: none (at least 0 N s/m).
        force_limit: N. largest force in both directions, unless locked; default: no limit (above 0 kN).

        A number is SI, a text has its unit. Returns the machine; its mistakes are told when it is calculated.
        """
    def tensioner(
        self,
        *,
        reeving: str | Quantity,
        change: str | Quantity,
        end: Literal["start", "end"] | None = None,
    ) -> Machine:
        """Adds one to `tensioners`: lengths of ropes changed by a signal.

        reeving: a reeving by name, or by its number from 1.
        change: change of the unstretched length: a signal, or a length; positive lengthens.
        end: end of the rope: `start`, `end`. Default: start.

        A number is SI, a text has its unit. Returns the machine; its mistakes are told when it is calculated.
        """
    def event(
        self,
        *,
        at: Quantity | None = None,
        when: str | Quantity | None = None,
        over: Quantity | None = None,
        break_: str | Quantity | None = None,
        stop: bool | None = None,
        actuator: str | Quantity | None = None,
        brake: str | Quantity | None = None,
        drive: str | Quantity | None = None,
        mode: str | Quantity | None = None,
        speed: str | Quantity | None = None,
        torque: str | Quantity | None = None,
        pull: str | Quantity | None = None,
    ) -> Machine:
        """Adds one to `events`: events of a transient, at a time or on a condition.

        at: s. time of the event (at least 0 s and at most 3.2e7 s).
        when: condition at which the event occurs, 'car.z > 12 m', with any quantity that 'observe' takes.
        over: s. of a break: time in which the tension falls to zero (at least 0 s and at most 3.2e7 s). Default: 0 s.
        break_: a reeving that breaks, or one of its branches: ext[2].
        stop: true: the run ends. Default: false.
        actuator: an actuator that changes its mode.
        brake: a drum whose brake is set, or with 'mode: open' opened.
        drive: a drum or driven sheave that gets a new speed, torque or pull; a brake that is set stays set.
        mode: new mode of an actuator: extend, retract, lock, free; of a brake: set (the default), open.
        speed: new speed of a drive: a signal, or a speed.
        torque: new torque of a drive: a signal, or a moment.
        pull: new pull of a drum drive: a signal, or a force.
        Give exactly one of at, when.
        Give exactly one of break, stop, actuator, brake, drive.

        A number is SI, a text has its unit. Returns the machine; its mistakes are told when it is calculated.
        """
    def measure(
        self,
        name: str,
        *,
        of: str | Quantity,
        seen_from: str | Quantity | None = None,
        factor: Quantity | None = None,
        offset: str | Quantity | None = None,
        since: Quantity | None = None,
        relative: Literal["none", "difference", "ratio"] | None = None,
        mean: Mapping[str, Any] | None = None,
        value: Literal["automatic", "mean", "end", "min", "max"] | None = None,
    ) -> Machine:
        """Adds one to `measures`: quantities of a motion under names of their own, recorded in addition to those of 'observe'.

        of: observed quantity: s3.x, ext[2].T, a signal.
        seen_from: a body: places, velocities and rotations are relative to its origin and axes.
        factor: factor on the quantity. Default: 1.
        offset: value added after the factor, with its unit.
        since: s. earlier values do not count (at least 0 s and at most 3.2e7 s). Default: 0 s.
        relative: difference from, or ratio to, the value at 'since': `none`, `difference`, `ratio`. Default: none.
        mean: interval of its mean.
        value: result value of this name: the mean where it has one, else the value at the end: `automatic`, `mean`, `end`,
            `min`, `max`. Default: automatic.

        A number is SI, a text has its unit. Returns the machine; its mistakes are told when it is calculated.
        """
