// What is open at each level, in its order, and the one that is shown there.
import type { ApplicationView, DocumentView } from '../api.gen'
import { desk } from '../link/desk.svelte'
import { canvas, pick } from '../state/canvas.svelte'
import { look, type Level } from '../state/look.svelte'
import { pickSteps, workspace, type Place } from '../state/workspace.svelte'
import { Refusal } from '../link/refusal'
import { showRefusal } from './refused.svelte'
import { t } from '../texts/index.svelte'
import { plain, say } from '../texts/say'

export type Opened = DocumentView | ApplicationView

const START: Place = { flow: '0', after: 0 }
/** Where the next icon would have gone in the applications that were shown before. */
const places = new Map<string, Place>()

/** The job that a configuration was opened from, so that one finds back. */
export const origin: { doc: string; app: string } = $state({ doc: '', app: '' })

/** As they are now, also while a recording is looked at: their tabs and the chips of the runtime speak of the present. */
const allOf = (level: Level): Readonly<Record<string, Opened>> =>
  level === 'applications' ? desk.live.applications : desk.live.documents
const levelOf = (id: string): Level => (id in desk.tree.applications ? 'applications' : 'tasks')
const shownAt = (level: Level): string => (level === 'applications' ? workspace.app : canvas.doc)

export const inOrder = (level: Level = look.level): [string, Opened][] =>
  Object.entries(allOf(level)).sort(([, a], [, b]) => a.order - b.order)

export const shownDocument = (): DocumentView | undefined => desk.live.documents[canvas.doc]
/** The id of what is shown at the level that is on show; empty: nothing is. */
export const shownId = (): string => shownAt(look.level)
export const shownOne = (): Opened | undefined => allOf(look.level)[shownId()]

/** What Undo takes back, in words: the last step of what is shown, or of what belongs to no file; empty: nothing. */
export const toUndo = (): string => say((shownOne() ?? { undo: desk.live.own_undo }).undo)
/** What Redo does again. */
export const toRedo = (): string => say((shownOne() ?? { redo: desk.live.own_redo }).redo)

/** Go to a level; what is shown and picked at the other one stays. */
export function goTo(level: Level): void {
  if (level === 'applications' || !look.isUpperOnly) look.level = level
  else
    showRefusal(
      new Refusal(plain(t('levels.hidden')), [
        { label: plain(t('levels.showLower')), act: { t: 'Prefer', values: { shows_lower: true } } },
      ]),
    )
}

/** Bring a document to the front, at its level. */
export function show(id: string): void {
  const level = levelOf(id)
  if (level === 'tasks' && look.level === 'applications' && workspace.app)
    Object.assign(origin, { doc: id, app: workspace.app })
  front(level, id)
  goTo(level)
}

function front(level: Level, id: string): void {
  if (id === shownAt(level)) return
  if (level === 'tasks') {
    canvas.doc = id
    pick()
    return
  }
  if (workspace.app) places.set(workspace.app, { ...workspace.place })
  workspace.app = id
  pickSteps()
  workspace.place = places.get(id) ?? { ...START }
}

/** The one before or after, round and round. */
export function step(by: 1 | -1): void {
  const ids = inOrder().map(([id]) => id)
  const next = ids[(ids.indexOf(shownId()) + by + ids.length) % ids.length]
  if (next) show(next)
}

/** Where a session begins: where there is something. */
export function begin(): void {
  const isBlank = inOrder('tasks').every(
    ([, document]) =>
      !document.path && !document.is_dirty && !('tasks' in document && Object.keys(document.tasks ?? {}).length),
  )
  if (isBlank && inOrder('applications').length) goTo('applications')
}

/** Keep something on show at both levels: what vanished gives way to its neighbour, what one opened oneself comes to the front. */
export function settle(former: ReadonlySet<string>): Set<string> {
  return new Set([...settled('tasks', former), ...settled('applications', former)])
}

function settled(level: Level, former: ReadonlySet<string>): string[] {
  const ids = inOrder(level).map(([id]) => id)
  if (!ids.includes(shownAt(level))) front(level, ids.find((id) => !former.has(id)) ?? ids.at(-1) ?? '')
  return ids
}
