// The menu beside the pointer: everything that can be done here, and why some of it cannot.
import { act } from '../act/act'
import { desk } from '../link/desk.svelte'
import { openDialog } from '../state/dialogs.svelte'
import { workspace } from '../state/workspace.svelte'
import type { Point } from '../act/refused.svelte'
import { homeOf } from '../application/redirectChoices'
import type { Item } from '../widgets/Menu.svelte'
import { isHeldToWords } from '../onikon/presentation'
import { say } from '../texts/say'
import { t } from '../texts/index.svelte'
import { headOf, topsOf } from '../application/actions'
import { workspaceState, type Opened } from './workspaceState.svelte'
import {
  addFlow,
  askForLoop,
  askForOther,
  askHowOften,
  copy,
  cut,
  edit,
  editPicture,
  exchange,
  expand,
  insert,
  meantHeads,
  paste,
  remove,
  removeFlow,
  setParallel,
  turnBreakpoint,
  whyNotExpand,
} from './acts'
import { flowName, nameOf } from '../application/words'

export function menuOf(opened: Opened): { label: string; at: Point; items: Item[] } | undefined {
  if (opened.kind !== 'menu') return undefined
  const { at, over } = opened
  if (over.kind === 'step')
    return { label: nameOf(workspaceState.step(over.step)), at, items: stepItems(over.step, at) }
  return { label: t('upper.menu'), at, items: [...placeItems(at), ...flowItems(over.kind === 'flow' ? over.flow : '')] }
}

/** Nothing but breakpoints is changed while the application runs (D18). */
function locked(item: Item): Item {
  return workspaceState.isRunning ? { ...item, isOff: true, note: t('upper.locked') } : item
}

function stepItems(step: number, at: Point): Item[] {
  const view = workspaceState.step(step)
  if (view?.kind === 'hole') return [...placeItems(at), ...holeItems(step)]
  const isBranch = view?.kind === 'branch'
  return [
    ...(workspaceState.isRunning
      ? [
          {
            label: t('upper.skipHere'),
            run: () => act({ t: 'SkipTo', step: headOf(workspaceState.actions, step), doc: workspace.app }, at),
          },
        ]
      : []),
    {
      label: t(isBranch ? 'upper.conditions' : view?.role === 'target' ? 'upper.values' : 'upper.words'),
      keys: 'F2',
      run: () => edit(step),
    },
    ...(isBranch ? [locked({ label: t('upper.addLane'), run: () => addFlow(step) })] : iconItems(step, at)),
    locked({ label: t('upper.cut'), keys: 'X', run: () => cut(), begins: true }),
    { label: t('upper.copy'), keys: 'C', run: () => copy() },
    locked({ label: t('upper.delete'), keys: 'Delete', run: () => remove() }),
    ...placeItems(at),
  ]
}

function holeItems(hole: number): Item[] {
  const [type] = workspaceState.step(hole)?.wants ?? []
  if (!type) return []
  return [locked({ label: t('upper.newTarget'), run: () => openDialog('target', { type }), begins: true })]
}

function iconItems(step: number, at: Point): Item[] {
  const view = workspaceState.step(step)
  const why = whyNotExpand(step)
  const onikon = desk.tree.onikons[workspace.onikon]
  return [
    ...(isHeldToWords() ? [] : [{ label: t('upper.picture'), run: () => editPicture(step) }]),
    {
      label: t(view?.role === 'application' ? 'upper.openApplication' : 'upper.openConfiguration'),
      run: () => expand(step),
      isOff: why !== '',
      note: why || undefined,
    },
    locked({ label: t('upper.replaceBy'), keys: 'R', run: () => askForOther(step) }),
    ...(onikon
      ? [
          locked({
            label: t('upper.exchange', { name: workspace.onikon }),
            run: () => exchange(step, workspace.onikon, at),
          }),
        ]
      : []),
    ...markItems(),
  ]
}

/** Marks are those of the action; a target without a job has none. */
function markItems(): Item[] {
  const heads = meantHeads()
  const [head] = heads
  const view = head === undefined ? undefined : workspaceState.step(head)
  const noAction = view?.role === 'target' ? t('upper.noAction') : undefined
  if (head === undefined || !view) return []
  const off = { isOff: noAction !== undefined, note: noAction }
  return [
    {
      label: t(view.breaks ? 'upper.unbreak' : 'upper.break'),
      keys: 'M',
      run: () => turnBreakpoint(),
      begins: true,
      ...off,
    },
    { label: t('upper.breakIf'), run: () => (workspaceState.opened = { kind: 'condition', step: head }), ...off },
    locked({
      label: t('upper.tag'),
      keys: 'S',
      run: () => (workspaceState.opened = { kind: 'tag', step: head }),
      ...off,
    }),
    locked({ label: t('upper.repeat'), run: () => askHowOften(), ...off }),
    locked({
      label: t(view.loop ? 'upper.changeLoop' : 'upper.loop'),
      keys: 'W',
      run: () => askForLoop(heads),
      ...off,
    }),
    ...(view.loop
      ? [locked({ label: t('upper.removeLoop'), run: () => act({ t: 'RemoveLoop', doc: workspace.app, step: head }) })]
      : []),
  ]
}

function placeItems(at: Point): Item[] {
  const buffer = desk.tree.icon_clipboard
  const { onikon } = workspace
  return [
    locked({
      label: t('upper.add'),
      keys: '/',
      run: () => (workspaceState.opened = { kind: 'quick', words: '' }),
      begins: true,
    }),
    ...(onikon
      ? [locked({ label: t('upper.insertIt', { name: onikon }), run: () => insert(onikon, workspace.place, at) })]
      : []),
    locked({
      label: t('upper.paste'),
      keys: 'V',
      run: () => paste(),
      isOff: !buffer,
      note: say(buffer) || t('upper.nothingCopied'),
    }),
    locked({
      label: t('upper.insertBranch'),
      keys: 'B',
      run: () => (workspaceState.opened = { kind: 'branch', step: 0 }),
    }),
  ]
}

function flowItems(path: string): Item[] {
  const { app } = workspaceState
  if (!app) return []
  const tops = topsOf(app)
  const flow = path || workspace.place.flow
  const isAlone = !flow.includes('/') && tops.length < 2
  return [
    locked({ label: t('upper.addFlow'), run: () => addFlow(), begins: true }),
    locked({
      label: t('upper.removeFlow', { name: flowName(flow) }),
      run: () => removeFlow(flow),
      isOff: isAlone,
      note: isAlone ? t('upper.lastFlow') : undefined,
    }),
    ...(tops.length > 1
      ? [
          locked({
            label: t(app.is_parallel ? 'upper.makeConditional' : 'upper.makeParallel'),
            run: () => setParallel(!app.is_parallel),
          }),
        ]
      : []),
    locked({ label: t('redirect.menu'), keys: 'Alt+I', run: () => openDialog('redirect', { flow: homeOf(flow) }) }),
    {
      label: t(workspaceState.isLettered ? 'upper.hideLetters' : 'upper.showLetters'),
      run: () => workspaceState.turnLetters(),
      begins: true,
    },
  ]
}
