// Commands of the strip: its tables, plots, questions and the workcell.
import { command } from '../state/commands'
import { openDialog } from '../state/dialogs.svelte'
import { desk, runsIn } from '../link/desk.svelte'
import { worldsIn } from '../link/stations'
import { canvas, type StripTab } from '../state/canvas.svelte'
import { watchAgain } from '../values/frames'
import { takenAsks } from '../holding/held'
import { everything } from '../holding/standing.svelte'
import { asking, asks } from '../question/asks.svelte'
import { inside } from '../progress/inside'
import { look } from '../state/look.svelte'
import { isWorldShown, plot, showWorld } from '../monitor/plots.svelte'
import { t } from '../texts/index.svelte'

const TITLES = {
  tasks: () => t('strip.showTasks'),
  variables: () => t('strip.showVariables'),
  problems: () => t('strip.showProblems'),
  log: () => t('strip.showLog'),
} satisfies Record<StripTab, () => string>

for (const [tab, title] of Object.entries(TITLES) as [StripTab, () => string][])
  command({ id: `strip.${tab}`, title, group: 'view', level: 'tasks', run: () => (canvas.strip = tab) })

command({ id: 'strip.refresh', title: () => t('strip.refresh'), group: 'run', level: 'tasks', run: watchAgain })
command({
  id: 'strip.plotPicked',
  title: () => t('strip.plotPicked'),
  group: 'view',
  level: 'tasks',
  when: () => canvas.pickedLocus !== '',
  run: () => plot(canvas.pickedLocus),
})
command({ id: 'strip.scope', title: () => t('scope.open'), group: 'view', run: () => openDialog('scope') })
command({
  id: 'strip.closePlots',
  title: () => t('strip.closePlots'),
  group: 'view',
  level: 'tasks',
  when: () => canvas.plots.length > 0,
  run: () => (canvas.plots = []),
})
command({
  id: 'strip.workcell',
  title: () => t('strip.showWorkcell'),
  group: 'view',
  level: 'tasks',
  when: () => firstWorld() !== undefined,
  run: () => {
    const world = firstWorld()
    if (world !== undefined) showWorld(world)
  },
})
command({
  id: 'strip.answer',
  title: () => t('ask.answer'),
  group: 'run',
  level: 'tasks',
  when: () => firstAsking() !== undefined,
  run: () => asks.open(firstAsking() ?? ''),
})

command({
  id: 'strip.inside',
  title: () => t('strip.inside'),
  group: 'view',
  level: 'applications',
  when: () => Object.keys(inside()).length > 0,
  run: () => (look.isInside = !look.isInside),
})

const firstWorld = (): string | undefined => worldsIn(desk.tree).find((name) => !isWorldShown(name))

function firstAsking(): string | undefined {
  return desk.live.review
    ? undefined
    : Object.keys(asking(desk.tree.documents[canvas.doc], runsIn(desk.tree), takenAsks(everything())))[0]
}
