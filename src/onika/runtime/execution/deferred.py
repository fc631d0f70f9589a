"""Deferred commands: spawns and exchanges wait for a gap between cycles, so that no task misses one (law 21)."""

from collections.abc import Callable
from types import CodeType

from msgspec import structs

from onika.model.lifecycle import State
from onika.runtime import command, news
from onika.runtime.execution.module_exchange import ModuleExchange
from onika.runtime.execution.running_task import RunningTask
from onika.runtime.execution.task_lifecycle import TaskLifecycle
from onika.runtime.execution.unit import Address, ProcessingUnit
from onika.runtime.modules.code import compiled
from onika.words.fault import Fault
from onika.words.reason import Reason

_PIECES = (command.Spawn, command.Swap)

PATIENCE_NS = 2_000_000_000
"""After so long without a gap that is large enough there will be none."""


class DeferredPiece:
    """What is put aside: the module is compiled, loaded, initialised; what came for its task waits behind it."""

    def __init__(self, order: command.Spawn | command.Swap, now: int) -> None:
        self.order = order
        self.code: CodeType | Fault | None = None
        self.task: RunningTask | None = None
        self.behind: list[command.Command] = []
        self.since = now
        self.largest_gap = 0

    @property
    def spawn(self) -> command.Spawn:
        """The task that comes."""
        if isinstance(self.order, command.Swap):
            return self.order.spawn
        return self.order

    @property
    def address(self) -> Address:
        """Subsystem and task."""
        return self.spawn.subsystem, self.spawn.task

    @property
    def word(self) -> str:
        """The command's name in a refusal."""
        if isinstance(self.order, command.Swap):
            return "swap"
        return "spawn"

    def need_ns(self, old: RunningTask | None) -> int:
        """What the next step is expected to take; the `init` of the module at work tells of that of its successor."""
        loading = self.spawn.cost_ns - self.spawn.init_ns
        if self.task is None:
            return loading
        return max(self.spawn.init_ns or loading, old.init_took_ns if old else 0)


CarryOut = Callable[[command.Command, int], None]
"""Told what waited behind a piece that is through."""


class DeferredCommands:
    """Pieces in the order in which they came."""

    def __init__(self, unit: ProcessingUnit, life: TaskLifecycle, exchange: ModuleExchange) -> None:
        self._unit = unit
        self._lifecycle = life
        self._exchange = exchange
        self._pieces: list[DeferredPiece] = []

    def __bool__(self) -> bool:
        return bool(self._pieces)

    def sift(self, order: command.Command, now: int) -> command.Command | None:
        """What of a command is to be carried out at once; the rest is put aside, or behind what is put aside."""
        if not self._pieces and not isinstance(order, _PIECES):
            return order
        match order:
            case command.Spawn() | command.Swap():
                return self._sift_piece(order, now)
            case command.Kill():
                return self._sift_kill(order, now)
            case command.Stop() | command.Quit():
                self._drop_all()
            case command.Rank() if self._pieces:
                return self._sift_rank(order)
            case (
                command.Reinit() | command.Rebind() | command.Answer() | command.Clear() | command.Get() | command.Set()
            ):
                piece = self._coming(order.subsystem, order.task)
                if piece is not None:
                    piece.behind.append(order)
                    return None
        return order

    def sift_switch(self, order: command.Switch) -> command.Switch:
        """What concerns tasks that are still to come waits behind them; the rest, above all what goes off, does not."""
        return self._sift_switch(order) if self._pieces else order

    def work(self, now: int, carry_out: CarryOut) -> None:
        """Do one step of one piece, the first for which there is room until the next release; give up old ones."""
        release = self._unit.scheduler.next_release()
        for piece in list(self._pieces):
            if not self._unit.is_ready(piece.spawn):
                continue
            gap = None if release is None else release - now
            if gap is None or gap >= self._need_ns(piece):
                self._advance(piece, now, carry_out)
                return
            piece.largest_gap = max(piece.largest_gap, gap)
            if now - piece.since > PATIENCE_NS:
                self._give_up(piece, now, carry_out)
                return

    # Inner

    def _need_ns(self, piece: DeferredPiece) -> int:
        return piece.need_ns(self._unit.tasks.get(piece.address))

    def _coming(self, subsystem: str, task: str) -> DeferredPiece | None:
        """The spawn of this task that waits."""
        return next(
            (piece for piece in self._pieces if piece.address == (subsystem, task) and piece.word == "spawn"), None
        )

    def _sift_piece(self, order: command.Spawn | command.Swap, now: int) -> command.Command | None:
        piece = DeferredPiece(order, now)
        coming = self._coming(*piece.address)
        if coming is not None and piece.word == "spawn":
            self._unit.refuse(piece.address, "spawn", Reason.of("runtime.on_its_way"))
            return None
        if coming is not None:
            coming.behind.append(order)
            return None
        if not piece.spawn.cost_ns or not self._unit.is_busy:
            return order
        self._pieces.append(piece)
        return None

    def _sift_kill(self, order: command.Kill, now: int) -> command.Command | None:
        mine = [piece for piece in self._pieces if piece.address == (order.subsystem, order.task)]
        for piece in mine:
            self._pieces.remove(piece)
            if piece.word == "spawn":
                self._unit.tell(news.Changed(*piece.address, State.KILLED.value, now))
                return None
            self._unit.refuse(piece.address, piece.word, Reason.of("runtime.killed_before"))
        return order

    def _sift_switch(self, order: command.Switch) -> command.Switch:
        now_on, now_rates, now_off = list(order.on), list(order.rates), list(order.off)
        for piece in self._pieces:
            subsystem, task = piece.address
            if subsystem != order.subsystem or piece.word != "spawn":
                continue
            later = command.Switch(
                subsystem,
                tuple(name for name in now_off if name == task),
                (),
                tuple(launch for launch in now_on if launch.task == task),
                tuple(rate for rate in now_rates if rate[0] == task),
            )
            now_off = [name for name in now_off if name != task]
            now_on = [launch for launch in now_on if launch.task != task]
            now_rates = [rate for rate in now_rates if rate[0] != task]
            if later.off or later.on or later.rates:
                piece.behind.append(later)
        return structs.replace(order, off=tuple(now_off), on=tuple(now_on), rates=tuple(now_rates))

    def _sift_rank(self, order: command.Rank) -> command.Command:
        ranks = []
        for name, rank in order.ranks:
            piece = self._coming(order.subsystem, name)
            if piece is None:
                ranks.append((name, rank))
            else:
                piece.behind.append(command.Rank(order.subsystem, ((name, rank),)))
        return command.Rank(order.subsystem, tuple(ranks))

    def _drop_all(self) -> None:
        for piece in self._pieces:
            self._unit.refuse(piece.address, piece.word, Reason.of("runtime.unit_stopped"))
        self._pieces.clear()

    def _advance(self, piece: DeferredPiece, now: int, carry_out: CarryOut) -> None:
        """Compile, load, initialise: each is a step of its own."""
        spawn = piece.spawn
        piece.since, piece.largest_gap = now, 0
        if piece.code is None and not spawn.is_sandboxed:
            piece.code = compiled(spawn.source, spawn.path, spawn.module)
            return
        if piece.task is None:
            piece.task = self._make(piece)
            if piece.task is None:
                self._end(piece, now, carry_out)
            return
        if piece.word == "swap":
            self._exchange.complete(piece.task, now)
        else:
            self._lifecycle.initialise(piece.task, now)
        self._end(piece, now, carry_out)

    def _make(self, piece: DeferredPiece) -> RunningTask | None:
        if isinstance(piece.order, command.Swap):
            return self._exchange.make(piece.order, piece.code)
        return self._lifecycle.make(piece.order, code=piece.code)

    def _give_up(self, piece: DeferredPiece, now: int, carry_out: CarryOut) -> None:
        needs, largest = self._need_ns(piece) / 1e6, piece.largest_gap / 1e6
        self._unit.refuse(piece.address, piece.word, Reason.of("runtime.no_gap", needs_ms=needs, largest_ms=largest))
        self._end(piece, now, carry_out)

    def _end(self, piece: DeferredPiece, now: int, carry_out: CarryOut) -> None:
        self._pieces.remove(piece)
        for order in piece.behind:
            carry_out(order, now)
