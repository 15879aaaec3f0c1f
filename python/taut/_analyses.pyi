"""Made from the descriptions by python/tools/make_stub.py; do not edit. `./dev python stub` makes it again.

schema: aae8f5e1c103c7bb24225c0a0a7f5313f4e7d0590ea7d9aa9152a804c14c4427
"""

from collections.abc import Mapping, Sequence
from os import PathLike
from typing import Any, Literal

from ._result import Result
from ._run import Progress
from ._units import Quantity

class Analyses:
    def solve(
        self,
        *,
        name: str | Quantity | None = None,
        judge: bool | None = None,
        motion: Mapping[str, Any] | None = None,
        carriage: str | Quantity | None = None,
        x: Quantity | None = None,
        z: Quantity | None = None,
        along: Quantity | Sequence[Quantity] | None = None,
        held: bool | None = None,
        given: Mapping[str, Any] | None = None,
        set: Mapping[str, Any] | None = None,
        progress: Progress | None = None,
    ) -> Result:
        """Calculates equilibrium of the machine: the machine in equilibrium.

        The deck's own analyses are left out; its checks are made. Returns the result, also where there is no answer.

        name: appended to the names of its tables, when a deck has several.
        judge: false: its states do not count for the verdict. Default: true.
        motion: hoist, lower, in, out, at_rest, or a sign for each contact by name: 1 along the path, -1 against it, 0 at
            rest.
        carriage: the carriage that is placed at x.
        x: m. place of the carriage; the quantity that holds it follows (at least -2e7 m and at most 2e7 m).
        z: m. height of the carriage; the given length or tension of the rope on which it rides follows (at least -1e7 m and
            at most 1e7 m).
        along: horizontal direction [x, y] along which its x is measured, from the origin.
        held: true: something besides the ropes holds the carriage at x; false: where it needs a force along its track there
            is no answer. Default: false.
        given: a required result, in place of the given quantity of one rope.
        set: values over the deck for this call alone, by path; a bare number is SI.
        progress: called with what, part done (0 to 1), words; a returned False ends it.

        A number is SI, a text has its unit. Raises DeckError for mistakes; Interrupted after Ctrl-C, with what was done.
        """
    def load_path(
        self,
        *,
        carriage: str | Quantity,
        from_: Quantity,
        to: Quantity,
        name: str | Quantity | None = None,
        judge: bool | None = None,
        steps: int | None = None,
        along: Quantity | Sequence[Quantity] | None = None,
        motion: Mapping[str, Any] | None = None,
        held: bool | None = None,
        given: Mapping[str, Any] | None = None,
        set: Mapping[str, Any] | None = None,
        progress: Progress | None = None,
    ) -> Result:
        """Calculates load_path of the machine: a carriage moved along its line.

        The deck's own analyses are left out; its checks are made. Returns the result, also where there is no answer.

        carriage: the carriage that is moved.
        from_: m. first place of the carriage (at least -2e7 m and at most 2e7 m).
        to: m. last place (at least -2e7 m and at most 2e7 m).
        name: appended to the names of its tables, when a deck has several.
        judge: false: its states do not count for the verdict. Default: true.
        steps: equal steps between them (at least 1 and at most 10000). Default: 96.
        along: horizontal direction [x, y] along which 'from' and 'to' are measured, from the origin.
        motion: as for an equilibrium.
        held: as for an equilibrium, at every position. Default: false.
        given: as for an equilibrium, at every position.
        set: values over the deck for this call alone, by path; a bare number is SI.
        progress: called with what, part done (0 to 1), words; a returned False ends it.

        A number is SI, a text has its unit. Raises DeckError for mistakes; Interrupted after Ctrl-C, with what was done.
        """
    def payload(
        self,
        *,
        carriage: str | Quantity,
        from_: Quantity,
        to: Quantity,
        limits: Mapping[str, Any],
        name: str | Quantity | None = None,
        judge: bool | None = None,
        steps: int | None = None,
        along: Quantity | Sequence[Quantity] | None = None,
        motion: Mapping[str, Any] | None = None,
        held: bool | None = None,
        most: Quantity | None = None,
        set: Mapping[str, Any] | None = None,
        progress: Progress | None = None,
    ) -> Result:
        """Calculates payload of the machine: the largest load within all limits.

        The deck's own analyses are left out; its checks are made. Returns the result, also where there is no answer.

        carriage: the carriage that carries the payload.
        from_: m. first place of the carriage (at least -2e7 m and at most 2e7 m).
        to: m. last place; the same as 'from' for one place (at least -2e7 m and at most 2e7 m).
        limits: limits, at least one.
        name: appended to the names of its tables, when a deck has several.
        judge: false: its states do not count for the verdict. Default: true.
        steps: equal steps between them (at least 1 and at most 10000). Default: 48.
        along: as for a load path.
        motion: as for an equilibrium; at rest the band counts.
        held: as for an equilibrium, at every position. Default: false.
        most: kg. upper bound of the payload (above 0 kg and at most 1e9 kg). Default: 100000 kg.
        set: values over the deck for this call alone, by path; a bare number is SI.
        progress: called with what, part done (0 to 1), words; a returned False ends it.

        A number is SI, a text has its unit. Raises DeckError for mistakes; Interrupted after Ctrl-C, with what was done.
        """
    def installation(
        self,
        *,
        reeving: str | Quantity,
        name: str | Quantity | None = None,
        judge: bool | None = None,
        temperatures: Quantity | Sequence[Quantity] | None = None,
        from_: Quantity | None = None,
        to: Quantity | None = None,
        steps: int | None = None,
        given: Mapping[str, Any] | None = None,
        set: Mapping[str, Any] | None = None,
        progress: Progress | None = None,
    ) -> Result:
        """Calculates installation of the machine: an empty rope put up: tensions, sags and lengths by temperature.

        The deck's own analyses are left out; its checks are made. Returns the result, also where there is no answer.

        reeving: the rope that is put up empty, without its carriages and what hangs on them.
        name: appended to the names of its tables, when a deck has several.
        judge: false: its states do not count for the verdict. Default: true.
        temperatures: K. temperatures, such as 15 degC; default: that of the machine (above -273.15 degC and at most 1726.8
            degC).
        from_: K. first temperature, in place of a list (above -273.15 degC and at most 1726.8 degC).
        to: K. last temperature (above -273.15 degC and at most 1726.8 degC).
        steps: equal steps between them; default: 10 (at least 1 and at most 10000).
        given: tension, length or sag; default: what the reeving gives.
        set: values over the deck for this call alone, by path; a bare number is SI.
        progress: called with what, part done (0 to 1), words; a returned False ends it.

        A number is SI, a text has its unit. Raises DeckError for mistakes; Interrupted after Ctrl-C, with what was done.
        """
    def cycle(
        self,
        *,
        carriage: str | Quantity,
        from_: Quantity,
        to: Quantity,
        phases: Sequence[Mapping[str, Any] | str],
        name: str | Quantity | None = None,
        judge: bool | None = None,
        steps: int | None = None,
        along: Quantity | Sequence[Quantity] | None = None,
        held: bool | None = None,
        speed: Quantity | None = None,
        set: Mapping[str, Any] | None = None,
        progress: Progress | None = None,
    ) -> Result:
        """Calculates cycle of the machine: pulls and energies of a working cycle.

        The deck's own analyses are left out; its checks are made. Returns the result, also where there is no answer.

        carriage: the carriage that is moved.
        from_: m. first place of the carriage in the first phase (at least -2e7 m and at most 2e7 m).
        to: m. last place in the first phase; phases without places of their own go back and forth (at least -2e7 m and at
            most 2e7 m).
        phases: phases in their order.
        name: appended to the names of its tables, when a deck has several.
        judge: false: its states do not count for the verdict. Default: true.
        steps: equal steps of each phase (at least 1 and at most 10000). Default: 48.
        along: as for a load path.
        held: as for an equilibrium, at every position. Default: false.
        speed: m/s. speed of the carriage, for powers and times (above 0 m/s and at most 1000 m/s).
        set: values over the deck for this call alone, by path; a bare number is SI.
        progress: called with what, part done (0 to 1), words; a returned False ends it.

        A number is SI, a text has its unit. Raises DeckError for mistakes; Interrupted after Ctrl-C, with what was done.
        """
    def envelope(
        self,
        *,
        name: str | Quantity | None = None,
        judge: bool | None = None,
        carriage: str | Quantity | None = None,
        from_: Quantity | None = None,
        to: Quantity | None = None,
        steps: int | None = None,
        along: Quantity | Sequence[Quantity] | None = None,
        held: bool | None = None,
        load_at: str | Quantity | None = None,
        loads: Quantity | Sequence[Quantity] | None = None,
        motions: Sequence[Literal["at_rest", "hoist", "lower", "in", "out"]] | None = None,
        temperatures: Quantity | Sequence[Quantity] | None = None,
        set: Mapping[str, Any] | None = None,
        progress: Progress | None = None,
    ) -> Result:
        """Calculates envelope of the machine: worst cases for sizing.

        The deck's own analyses are left out; its checks are made. Returns the result, also where there is no answer.

        name: appended to the names of its tables, when a deck has several.
        judge: false: its states do not count for the verdict. Default: true.
        carriage: the carriage that is moved; without it the machine as described.
        from_: m. first place of the carriage (at least -2e7 m and at most 2e7 m).
        to: m. last place (at least -2e7 m and at most 2e7 m).
        steps: equal steps between them (at least 1 and at most 10000). Default: 48.
        along: as for a load path.
        held: as for an equilibrium, at every position. Default: false.
        load_at: the body or carriage with the loads, at its centre of mass, or a point of one; default: the carriage.
        loads: kg. loads, each in addition to those of the machine (at least 0 kg and at most 1e9 kg).
        motions: motions; default: at_rest: `at_rest`, `hoist`, `lower`, `in`, `out`.
        temperatures: K. temperatures; default: that of the machine (above -273.15 degC and at most 1726.8 degC).
        set: values over the deck for this call alone, by path; a bare number is SI.
        progress: called with what, part done (0 to 1), words; a returned False ends it.

        A number is SI, a text has its unit. Raises DeckError for mistakes; Interrupted after Ctrl-C, with what was done.
        """
    def sweep(
        self,
        *,
        parameter: str | Quantity,
        from_: str | Quantity,
        to: str | Quantity,
        name: str | Quantity | None = None,
        judge: bool | None = None,
        steps: int | None = None,
        motion: Mapping[str, Any] | None = None,
        carriage: str | Quantity | None = None,
        x: Quantity | None = None,
        along: Quantity | Sequence[Quantity] | None = None,
        held: bool | None = None,
        set: Mapping[str, Any] | None = None,
        progress: Progress | None = None,
    ) -> Result:
        """Calculates sweep of the machine: the equilibrium over a number of the deck.

        The deck's own analyses are left out; its checks are made. Returns the result, also where there is no answer.

        parameter: a number of the machine by its path in the deck: 'loads[0].mass', 'reevings.skyline.length',
            'temperature', 'points.head[2]', 'loads[0].force.angle'.
        from_: first value, with the unit of the parameter.
        to: last value.
        name: appended to the names of its tables, when a deck has several.
        judge: false: its states do not count for the verdict. Default: true.
        steps: equal steps between them (at least 1 and at most 10000). Default: 20.
        motion: as for an equilibrium.
        carriage: the carriage that is placed at x.
        x: m. its place (at least -2e7 m and at most 2e7 m).
        along: as for an equilibrium.
        held: as for an equilibrium. Default: false.
        set: values over the deck for this call alone, by path; a bare number is SI.
        progress: called with what, part done (0 to 1), words; a returned False ends it.

        A number is SI, a text has its unit. Raises DeckError for mistakes; Interrupted after Ctrl-C, with what was done.
        """
    def motion(
        self,
        *,
        duration: Quantity,
        name: str | Quantity | None = None,
        judge: bool | None = None,
        output_step: Quantity | None = None,
        tolerance: Quantity | None = None,
        step: Quantity | None = None,
        method: Literal["implicit", "verlet", "reference"] | None = None,
        start: Literal["settled", "assembled", "sliding"] | None = None,
        slid: Sequence[Mapping[str, Any] | str] | None = None,
        quasi_static: bool | None = None,
        damping_ratio: Quantity | None = None,
        rope_mass: bool | None = None,
        branches: Literal["straight", "catenary", "by_weight"] | None = None,
        arcs: Literal["stretch", "rigid"] | None = None,
        save: str | Quantity | None = None,
        restart: str | Quantity | None = None,
        hoist_factor: Mapping[str, Any] | None = None,
        set: Mapping[str, Any] | None = None,
        progress: Progress | None = None,
    ) -> Result:
        """Calculates transient of the machine: a motion of the machine.

        The deck's own analyses are left out; its checks are made. Returns the result, also where there is no answer.

        duration: s. duration, from the start or the restart (above 0 s and at most 3.2e7 s).
        name: appended to the names of its tables and files, when a deck has several.
        judge: false: its states do not count for the verdict. Default: true.
        output_step: s. time between two recorded lines; default: a thousandth of the duration (above 0 s and at most 3.2e7
            s).
        tolerance: largest error of the steps, relative to the largest tension, the size of the machine and the energy
            exchanged; default 1e-5, with the reference 1e-6, with verlet or a given step 1e-3 (at least 1e-12 and at most
            0.1).
        step: s. fixed step, without error control; a warning tells an error of the tensions above the tolerance (above 0
            s).
        method: implicit with steps by the tolerance, explicit (verlet) for waves and breaks, or the slow reference (IDA of
            SUNDIALS) to judge both: `implicit`, `verlet`, `reference`. Default: implicit.
        start: settled: from the equilibrium at rest; assembled: places and lengths as described, at rest; sliding: settled,
            with the friction after the slow movement that 'slid' gives: `settled`, `assembled`, `sliding`. Default:
            settled.
        slid: slow movements before a start 'sliding'.
        quasi_static: true: slow motion without inertia: an equilibrium at the end of every step, with friction. Default:
            false.
        damping_ratio: damping ratio of ropes without their own, in the lowest mode that stretches the rope (at least 0 and
            at most 10). Default: 0.
        rope_mass: false: ropes without weight and inertia. Default: true.
        branches: straight: half of the weight of a branch at each end; catenary: the elastic catenary at rest between its
            moving ends; by_weight: catenary where a branch weighs more than 5 % of its tension at the start: `straight`,
            `catenary`, `by_weight`. Default: straight.
        arcs: stretch: rope on a round stretches with the branches beside it; rigid: it keeps the strain with which it came
            there: `stretch`, `rigid`. Default: stretch.
        save: file for the final state, in the folder of the results.
        restart: file with such a state from which to continue, beside the deck.
        hoist_factor: checks peak over static tension of a rope against phi2 = phi2_min + beta2 v_h of EN 13001-2.
        set: values over the deck for this call alone, by path; a bare number is SI.
        progress: called with what, part done (0 to 1), words; a returned False ends it.

        A number is SI, a text has its unit. Raises DeckError for mistakes; Interrupted after Ctrl-C, with what was done.
        """
    def modes(
        self,
        *,
        name: str | Quantity | None = None,
        judge: bool | None = None,
        count: int | None = None,
        start: Literal["settled", "assembled"] | None = None,
        damping_ratio: Quantity | None = None,
        rope_mass: bool | None = None,
        branches: Literal["straight", "catenary", "by_weight"] | None = None,
        set: Mapping[str, Any] | None = None,
        progress: Progress | None = None,
    ) -> Result:
        """Calculates modes of the machine: small vibrations: frequencies, damping, shapes.

        The deck's own analyses are left out; its checks are made. Returns the result, also where there is no answer.

        name: appended to the names of its tables, when a deck has several.
        judge: false: its states do not count for the verdict. Default: true.
        count: number of modes, lowest first (at least 1 and at most 400). Default: 10.
        start: settled: about the equilibrium at rest; assembled: places and lengths as described: `settled`, `assembled`.
            Default: settled.
        damping_ratio: damping ratio of ropes without their own, in the lowest mode that stretches the rope (at least 0 and
            at most 10). Default: 0.
        rope_mass: false: ropes without weight and inertia. Default: true.
        branches: branches, as in a transient: `straight`, `catenary`, `by_weight`. Default: straight.
        set: values over the deck for this call alone, by path; a bare number is SI.
        progress: called with what, part done (0 to 1), words; a returned False ends it.

        A number is SI, a text has its unit. Raises DeckError for mistakes; Interrupted after Ctrl-C, with what was done.
        """
    def pretension(
        self,
        *,
        name: str | Quantity | None = None,
        judge: bool | None = None,
        pull: Sequence[Mapping[str, Any] | str] | None = None,
        least: Mapping[str, Any] | None = None,
        rounds: int | None = None,
        longest: Quantity | None = None,
        tolerance: Quantity | None = None,
        start: Literal["settled", "assembled"] | None = None,
        set: Mapping[str, Any] | None = None,
        progress: Progress | None = None,
    ) -> Result:
        """Calculates pretension of the machine: ropes tightened one after the other, as they are put up.

        The deck's own analyses are left out; its checks are made. Returns the result, also where there is no answer.

        name: appended to the names of its tables, when a deck has several.
        judge: false: its states do not count for the verdict. Default: true.
        pull: pulls, one after the other.
        least: lengths of ropes for which each keeps a least tension under all loads.
        rounds: number of times that the list of pulls is repeated (at least 1 and at most 1000). Default: 1.
        longest: m. largest length that a pull may take out or let in; default: 0.5 m with contacts or cylinders, else any
            (above 0 m and at most 10000 m).
        tolerance: tolerance of tensions relative to the largest of the rope, of places relative to the size of the machine
            (at least 1e-13 and at most 0.001). Default: 1e-9.
        start: of a machine with contacts or cylinders. settled: from the equilibrium at rest; assembled: from places and
            lengths as described, held by friction: `settled`, `assembled`. Default: settled.
        Give exactly one of pull, least.
        set: values over the deck for this call alone, by path; a bare number is SI.
        progress: called with what, part done (0 to 1), words; a returned False ends it.

        A number is SI, a text has its unit. Raises DeckError for mistakes; Interrupted after Ctrl-C, with what was done.
        """
    def study(
        self,
        *,
        vary: Mapping[str, Any] | None = None,
        correlate: Sequence[Any] | None = None,
        of: str | Sequence[str] | None = None,
        limit: Mapping[str, Any] | None = None,
        points: Literal["random", "lhs", "sobol", "grid"] | None = None,
        answer: Sequence[Literal["quantiles", "indices", "tornado", "form", "sorm", "importance"]] | None = None,
        samples: int | None = None,
        seed: int | None = None,
        confidence: Quantity | None = None,
        folder: str | PathLike[str] | None = None,
        threads: int | None = None,
        set: Mapping[str, Any] | None = None,
        progress: Progress | None = None,
    ) -> Result:
        """Calculates many cases of the machine on all cores.

        Without keywords: the `study:` of the deck. All cases are in series["cases"] of the result.

        vary: how numbers of the deck vary, by their whole path: 'machine.loads[0].mass'.
        correlate: pairs of inputs that vary together: [path, path, r].
        of: values asked for, by analysis and name: 'equilibrium.skyline.safety_factor'; of a method by name.
        limit: limits of some of them.
        points: where the cases lie: independent random numbers, Latin hypercubes, scrambled Sobol points, or a grid of
            lists and steps: `random`, `lhs`, `sobol`, `grid`. Default: sobol.
        answer: what is made of the cases: `quantiles`, `indices`, `tornado`, `form`, `sorm`, `importance`.
        samples: number of cases, rounded up to whole replicates; a grid has its own number (at least 16 and at most 1e8).
            Default: 10000.
        seed: of the random numbers; the same seed gives the same cases (at least 0). Default: 1.
        confidence: of all intervals, two-sided (above 0.5 and below 1). Default: 0.95.
        folder: keeps the cases there and goes on where it was ended.
        threads: default: all cores.
        set: values over the deck for this call alone, by path; a bare number is SI.
        progress: called with what, part done (0 to 1), words; a returned False ends it.

        A number is SI, a text has its unit. Raises DeckError for mistakes; Interrupted after Ctrl-C, with what was done.
        """
