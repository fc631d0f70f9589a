// Commands of a run: begin it, steer it, end it, look at why it stands.
import { announce } from '../state/announce'
import { command } from '../state/commands'
import { desk, runsIn } from '../link/desk.svelte'
import { dialogs } from '../state/dialogs.svelte'
import { workspace } from '../state/workspace.svelte'
import { options } from '../state/options.svelte'
import {
  canPause,
  dismiss,
  flowsOf,
  isGoing,
  pauseOrContinue,
  putBack,
  startAfresh,
  startAnew,
  steer,
} from '../run/orders'
import { anewWords } from '../progress/recording'
import { skipMode } from '../run/skipMode.svelte'
import { isReviewing } from '../recording/review.svelte'
import { shownStop, standstills } from '../progress/shownStop.svelte'
import '../run/runTime.svelte'
import { takenAsks } from '../holding/held'
import { everything } from '../holding/standing.svelte'
import { asking as allAsking, asks } from '../question/asks.svelte'
import { t } from '../texts/index.svelte'

const run = () => (isReviewing() ? null : desk.live.run)
const waiting = (): string | undefined => flowsOf(run()).find((name) => run()?.flows?.[name]?.state === 'waiting')
const asking = (): string | undefined =>
  Object.keys(allAsking(undefined, isReviewing() ? [] : runsIn(desk.now), takenAsks(everything())))[0]
const looping = (): string | undefined => flowsOf(run()).find((name) => run()?.flows?.[name]?.loops?.length)

/** Panels that ask for something: what is typed is meant for them, and a key does not set the machine in motion beneath them. */
const ASKING: readonly string[] = ['open', 'saveAs', 'newApplication', 'target', 'icon', 'job', 'keep']
function moves(deed: () => unknown): unknown {
  return ASKING.includes(dialogs.current.name) ? announce(t('perform.underPanel')) : deed()
}

/** Begin; while it runs the same key goes on after a pause, and never loads the page anew. */
function begin(): unknown {
  if (!isGoing() || (workspace.app && run()?.doc !== workspace.app)) return startAfresh(workspace.app)
  return canPause(run()) ? announce(t('perform.running')) : steer('continue')
}

command({
  id: 'application.run',
  group: 'application',
  level: 'applications',
  title: () => t('perform.run'),
  keys: ['F5', 'Ctrl+Enter'],
  when: () => workspace.app !== '' || isGoing(),
  run: () => moves(begin),
  whileTyping: true,
})
command({
  id: 'application.pause',
  group: 'application',
  title: () => (canPause(run()) ? t('perform.pause') : t('perform.continue')),
  keys: ['F8'],
  when: isGoing,
  run: () => (canPause(run()) ? pauseOrContinue() : moves(pauseOrContinue)),
  whileTyping: true,
})
command({
  id: 'application.step',
  group: 'application',
  title: () => t('perform.step'),
  keys: ['F10'],
  when: isGoing,
  run: () => moves(() => steer('step')),
  whileTyping: true,
})
command({
  id: 'application.skip',
  group: 'application',
  level: 'applications',
  title: () => t('perform.skip'),
  keys: ['Alt+J'],
  when: isGoing,
  run: () => skipMode.turn(),
})
command({
  id: 'application.release',
  group: 'application',
  title: () => t('perform.release'),
  keys: ['Alt+G'],
  when: () => isGoing() && waiting() !== undefined,
  run: () => steer('pass', waiting()),
})
command({
  id: 'application.answer',
  group: 'application',
  level: 'applications',
  title: () => t('ask.answer'),
  keys: ['Alt+A'],
  when: () => asking() !== undefined,
  run: () => asks.open(asking() ?? ''),
})
command({
  id: 'application.leave',
  group: 'application',
  title: () => t('perform.leave'),
  keys: ['Alt+L'],
  when: () => isGoing() && looping() !== undefined,
  run: () => steer('leave', looping()),
})
command({
  id: 'application.abort',
  group: 'application',
  title: () => t('perform.abort'),
  keys: ['Shift+F5'],
  when: isGoing,
  run: () => steer('abort'),
  whileTyping: true,
})
command({
  id: 'application.why',
  group: 'application',
  level: 'applications',
  title: () => t('stopped.chipEnd'),
  keys: ['Alt+Y'],
  when: () => standstills(run()).length > 0,
  run: () => (shownStop.shown ? shownStop.putAside() : shownStop.open()),
})
command({
  id: 'application.dismiss',
  group: 'application',
  level: 'applications',
  title: () => t('perform.dismiss'),
  when: () => run()?.state === 'over',
  run: dismiss,
})
command({
  id: 'application.putBack',
  group: 'application',
  level: 'applications',
  title: () => anewWords(desk.live.runtime).name,
  when: () => ['linked', 'lost'].includes(desk.tree.runtime.state ?? '') && !isGoing() && !isReviewing(),
  run: putBack,
})
command({
  id: 'application.startAnew',
  group: 'application',
  level: 'applications',
  title: () => t('perform.startAnew'),
  when: () => desk.tree.runtime.state === 'linked' && !desk.tree.runtime.address && !isReviewing(),
  run: startAnew,
})
command({
  id: 'application.passes',
  group: 'application',
  level: 'applications',
  title: () => (options.passesBreakpoints ? `${t('perform.passes')} ✓` : t('perform.passes')),
  run: () => (options.passesBreakpoints = !options.passesBreakpoints),
})
command({
  id: 'application.stopSkipping',
  group: 'application',
  title: () => t('perform.cancel'),
  keys: ['Escape'],
  when: () => skipMode.isOn,
  run: () => skipMode.end(),
})
