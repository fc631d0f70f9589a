// Commands about who may move the robots.
import { act } from '../act/act'
import { command } from '../state/commands'
import { desk } from '../link/desk.svelte'
import { stationsIn } from '../link/stations'
import { closeDialog, dialogs, openDialog } from '../state/dialogs.svelte'
import { everything, onlyWatches } from '../holding/standing.svelte'
import { t } from '../texts/index.svelte'

const isThere = (): boolean => stationsIn(desk.live).some(([, runtime]) => runtime.state === 'linked')
const offer = () => everything().find((held) => held.isOfferedHere)

command({
  id: 'run.holding',
  group: 'run',
  title: () => t('holding.open'),
  keys: ['Alt+H'],
  when: isThere,
  run: () => (dialogs.current.name === 'holding' ? closeDialog() : openDialog('holding')),
})
command({
  id: 'run.bookings',
  group: 'run',
  title: () => t('book.open'),
  when: isThere,
  run: () => (dialogs.current.name === 'bookings' ? closeDialog() : openDialog('bookings')),
})
command({
  id: 'run.accept',
  group: 'run',
  title: () => t('holding.accept'),
  when: () => offer() !== undefined,
  run: () => act({ t: 'Take', subsystem: offer()!.subsystems[0]!, station: offer()!.station }),
})
command({
  id: 'run.decline',
  group: 'run',
  title: () => t('holding.decline'),
  when: () => offer() !== undefined,
  run: () => act({ t: 'Decline', subsystem: offer()!.subsystems[0]!, station: offer()!.station }),
})
command({
  id: 'run.watch',
  group: 'run',
  title: () => t('holding.watch'),
  when: () => isThere() && !!desk.live.runtime.address && !onlyWatches(),
  run: () => act({ t: 'OnlyWatch' }),
})
command({
  id: 'run.watchNoMore',
  group: 'run',
  title: () => t('holding.watchNoMore'),
  when: onlyWatches,
  run: () => act({ t: 'WatchNoMore' }),
})
