"""The rendezvous with one thing wrong, several times: mistakes for `rendezvous_sim` to find."""

from dataclasses import replace

from kit.engine.rendezvous_runtime import HONEST, Parts, SimExecutive, SimRuntime
from onika.engine.rendezvous import Rendezvous
from onika.engine.rendezvous_exchange import RendezvousExchange, _Peer
from onika.engine.rendezvous_orders import AllMet, Confirm, Permit, RendezvousOrder
from onika.wire.rendezvous import Phase, RendezvousReport


class HoldsNobody(SimExecutive):
    holds = False


class BeginsLate(SimExecutive):
    def __init__(self, runtime: SimRuntime, *, is_shared: bool) -> None:
        super().__init__(runtime, is_shared=is_shared)
        self.late_ns = 10**12


class CommitsLate(Rendezvous):
    def _look_armed(self, now_ns: int) -> list[RendezvousOrder]:
        commit_ns = self.at_ns - self._terms.commit_ns
        return super()._look_armed(min(now_ns, commit_ns) if now_ns >= commit_ns else now_ns)


class BeginsWhenItIsTold(Rendezvous):
    """As if the environment, or whoever leads, said GO to all."""

    def _arm(self, attempt: int, convenor: int, proposed_ns: int, at_ns: int) -> list[RendezvousOrder]:
        now_ns = at_ns - self._terms.lead_ns
        orders = super()._arm(attempt, convenor, proposed_ns, at_ns if convenor == self.site else now_ns)
        self.state = replace(self.state, phase=Phase.COMMITTED)
        return [Permit(attempt), *orders]

    def _look_committed(self, now_ns: int) -> list[RendezvousOrder]:
        return []

    def _look_begun(self, now_ns: int) -> list[RendezvousOrder]:
        return super()._look_begun(now_ns) if all(map(self._began, map(self._of, self._needed()))) else []

    def _follow(self, convenor: int, now_ns: int) -> list[RendezvousOrder]:
        proposal = self._of(convenor)
        if proposal.visit != self.state.visit or proposal.phase not in (Phase.ARMED, Phase.COMMITTED, Phase.GO):
            return []
        if proposal.attempt <= self._dead:
            return []
        return self._arm(proposal.attempt, convenor, proposal.at_ns, now_ns + self._terms.lead_ns)


class BeginsWithoutCommitting(BeginsWhenItIsTold):
    """Whoever has heard of the time begins then, whatever he hears of the others."""

    def _arm(self, attempt: int, convenor: int, proposed_ns: int, at_ns: int) -> list[RendezvousOrder]:
        orders = Rendezvous._arm(self, attempt, convenor, proposed_ns, at_ns)
        self.state = replace(self.state, phase=Phase.COMMITTED)
        return [Permit(attempt), *orders]

    def _follow(self, convenor: int, now_ns: int) -> list[RendezvousOrder]:
        proposal = self._of(convenor)
        if proposal.visit != self.state.visit or proposal.attempt <= self._dead or not proposal.at_ns:
            return []
        at_ns = self._here(convenor, proposal.at_ns, now_ns)
        return [] if at_ns is None else self._arm(proposal.attempt, convenor, proposal.at_ns, at_ns)


class GoesOnWithoutHearingOfBegins(Rendezvous):
    def _look_begun(self, now_ns: int) -> list[RendezvousOrder]:
        self.state = replace(self.state, phase=Phase.MET)
        return [Confirm(self.state.attempt), AllMet()]


class MeetsAgainUnasked(Rendezvous):
    """As if whatever has begun alone had moved nothing."""

    def _stop(self) -> list[RendezvousOrder]:
        orders = super()._stop()
        self._is_clearing = True
        return orders


class BelievesEveryLife(RendezvousExchange):
    def _counts(self, peer: _Peer, count: int, report: RendezvousReport) -> bool:
        return True


MISTAKES: dict[str, Parts] = {
    "begins when it is told": replace(HONEST, rendezvous=BeginsWhenItIsTold, executive=HoldsNobody),
    "begins without committing": replace(HONEST, rendezvous=BeginsWithoutCommitting, executive=HoldsNobody),
    "goes on without hearing of begins": replace(HONEST, rendezvous=GoesOnWithoutHearingOfBegins),
    "begins late": replace(HONEST, rendezvous=CommitsLate, executive=BeginsLate),
    "believes every life": replace(HONEST, exchange=BelievesEveryLife),
    "meets again unasked": replace(HONEST, rendezvous=MeetsAgainUnasked),
    "holds nobody": replace(HONEST, executive=HoldsNobody),
}
