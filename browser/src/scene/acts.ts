// What a user can do on the canvas, whether by hand, key or menu. Each sends one act; the environment decides.
import { act } from '../act/act'
import { announce } from '../state/announce'
import type { Align } from '../api.gen'
import { desk } from '../link/desk.svelte'
import { runtimeAt } from '../link/stations'
import { canvas, pick } from '../state/canvas.svelte'
import { openDialog } from '../state/dialogs.svelte'
import { note as tell } from '../link/note'
import type { Point } from '../act/refused.svelte'
import { t } from '../texts/index.svelte'
import { lociWith } from './groups'
import { canvasState } from './canvasState.svelte'

export type Edge = Align['edge']

const GRID = 5
export const onGrid = (value: number): number => Math.round(value / GRID) * GRID

/** The text that was copied last here: the environment still has it in its buffer. */
let copied = ''

export const pickedTasks = (): string[] => [...canvas.picked].filter((name) => canvasState.document?.tasks?.[name])

/** What is picked and where a drag ends is known to this page alone; the diary hears of it (H01). */
export const note = (event: string, ...names: readonly string[]): void =>
  tell(event, names.join(','), names.map((name) => `${canvas.doc}/${name}`).join(','), 'conf')

export function select(name: string): void {
  pick(name)
  canvasState.focus = `task:${name}`
  note('select_icon', name)
}

export function selectLocus(svar: string): void {
  canvas.picked.clear()
  canvas.pickedLocus = svar
  canvasState.focus = `locus:${svar}`
}

export function deselect(): void {
  canvas.picked.clear()
  canvas.pickedLocus = ''
}

export function selectAll(): void {
  pick(...Object.keys(canvasState.document?.tasks ?? {}))
}

/** Where a task's box would have its corner if it were let go at a place of the page: held by its head, or by its corner. */
export function cornerAt({ width }: { width: number }, at: Point, isByHead: boolean): [number, number] {
  const [x, y] = canvasState.view.toScene(at.x, at.y)
  return isByHead ? [onGrid(x - width / 2), onGrid(y - 20)] : [onGrid(x), onGrid(y)]
}

/** Place a library task at a place of the page; asks for the unit where there are several. */
export function placeAt(task: string, at: Point, isByHead = true): void {
  const size = desk.tree.tasks[task]
  if (!size) return
  const corner = cornerAt(size, at, isByHead)
  const units = unitsAlive()
  if (canvasState.isLive && units.length > 1) canvasState.opened = { kind: 'units', at, task, corner }
  else void place(task, corner, at)
}

/** In the middle of what is seen, beside what stands there already: for those who use no pointer. */
export function placeInMiddle(task: string): void {
  const size = desk.tree.tasks[task]
  if (!size) return
  const { x, y } = canvasState.view.centre
  let [px, py] = [onGrid(x - size.width / 2), onGrid(y - size.height / 2)]
  while (
    canvasState.scene.boxesIn({ x0: px - 10, y0: py - 10, x1: px + size.width + 10, y1: py + size.height + 10 }).length
  ) {
    px += 30
    py += 30
  }
  const [cx, cy] = canvasState.view.toClient(px, py)
  placeAt(task, { x: cx, y: cy }, false)
}

export const unitsAlive = (): string[] =>
  Object.entries(runtimeAt(desk.tree, desk.tree.documents[canvas.doc]?.station).units ?? {})
    .filter(([, unit]) => !unit.is_lost)
    .map(([name]) => name)
    .sort()

export async function place(task: string, [x, y]: [number, number], at?: Point, rtpu = ''): Promise<void> {
  canvasState.close()
  const answer = await act({ t: 'Place', doc: canvas.doc, task, x, y, rtpu }, at)
  if (answer === undefined) return
  canvasState.begin()
  canvas.libraryTask = ''
  select(task)
  announce(t('canvas.placed', { name: task }))
}

export function exchange(old: string, task: string, at?: Point): void {
  void act({ t: 'Exchange', doc: canvas.doc, old, new: task }, at)
}

export function remove(tasks = pickedTasks()): void {
  if (tasks.length) void act({ t: 'Remove', doc: canvas.doc, tasks })
}

export function flip(tasks = pickedTasks()): void {
  if (tasks.length) void act({ t: 'Flip', doc: canvas.doc, tasks })
}

export function align(edge: Edge): void {
  if (pickedTasks().length > 1) void act({ t: 'Align', doc: canvas.doc, tasks: pickedTasks(), edge })
}

/** In columns along the flow of data: what is picked, if that is several tasks, else all. */
export async function arrange(): Promise<void> {
  const tasks = pickedTasks().length > 1 ? pickedTasks() : []
  await act({ t: 'Arrange', doc: canvas.doc, tasks })
  if (!tasks.length) canvasState.fit()
}

/** All tasks of the configuration come on together, producers before consumers, or go off. */
export function turnAll(isOn: boolean, at?: Point): void {
  const tasks = Object.keys(canvasState.document?.tasks ?? {})
  if (tasks.length) turn(tasks, isOn, at)
}

export async function copy(tasks = pickedTasks()): Promise<void> {
  if (!tasks.length) return
  takeText(await act({ t: 'Copy', doc: canvas.doc, tasks }))
}

export async function cut(tasks = pickedTasks()): Promise<void> {
  if (!tasks.length) return
  takeText(await act({ t: 'Cut', doc: canvas.doc, tasks }))
}

/** Where the pointer is, else the middle of what is seen. */
export async function paste(text = ''): Promise<void> {
  const { pointer, view } = canvasState
  const [x, y] = pointer ? view.toScene(pointer.x, pointer.y) : [view.centre.x, view.centre.y]
  await act({ t: 'Paste', doc: canvas.doc, x: onGrid(x), y: onGrid(y), text: text === copied ? '' : text }, pointer)
}

/** The text of what was copied also goes to the system's clipboard, where the browser allows it. */
function takeText(text: unknown): void {
  if (typeof text !== 'string') return
  copied = text
  void navigator.clipboard?.writeText(text).catch(() => undefined)
}

export function toggle(task: string, at?: Point): void {
  void act({ t: 'Toggle', doc: canvas.doc, task }, at)
}

export function turn(tasks: string[], isOn: boolean, at?: Point): void {
  void act({ t: 'Turn', doc: canvas.doc, tasks, is_on: isOn }, at)
}

export function clear(task: string, turnsOn: boolean, at?: Point): void {
  void act({ t: 'Clear', doc: canvas.doc, task, turns_on: turnsOn }, at)
}

/** Show or hide the lines of a variable. A constant of the row is brought onto the canvas, and back. */
export function toggleLines(svar: string): void {
  const locus = canvasState.document?.loci?.[svar]
  if (!locus) return
  const isHidden = locus.is_shown === false
  if (!locus.is_constant || canvasState.isConstantsShown) return showLines([svar], isHidden)
  if (isHidden) showLines([svar], true)
  if (isHidden || !canvasState.openedConstants.delete(svar)) canvasState.openedConstants.add(svar)
}

export function showLines(svars: string[], isShown: boolean): void {
  if (svars.length) void act({ t: 'Show', doc: canvas.doc, svars, is_shown: isShown })
}

/** Bring all constants onto the canvas, or back into their row. */
export function toggleConstants(): void {
  const loci = Object.entries(canvasState.document?.loci ?? {}).filter(([, locus]) => locus.is_constant)
  const hidden = loci.filter(([, locus]) => locus.is_shown === false).map(([svar]) => svar)
  if (!canvasState.isConstantsShown) showLines(hidden, true)
  canvasState.toggleConstants()
}

export function togglePin(svar: string): void {
  canvas.pinned = canvas.pinned.includes(svar)
    ? canvas.pinned.filter((name) => name !== svar)
    : [...canvas.pinned, svar]
}

/** One step for all that was moved. */
export function move(
  tasks: Record<string, [number, number]>,
  loci: Record<string, [number, number]> = {},
  at?: Point,
): Promise<unknown> {
  return act({ t: 'Move', doc: canvas.doc, tasks, loci }, at)
}

type Corners = Record<string, [number, number]>

/** Where nudged things are on their way to: keys come faster than answers. */
const bound = { tasks: new Map<string, [number, number]>(), loci: new Map<string, [number, number]>() }

export function nudge(dx: number, dy: number): void {
  const { boxes, dots } = canvasState.scene
  const dot = canvas.pickedLocus ? dots.get(canvas.pickedLocus) : undefined
  const goals = (
    names: string[],
    things: ReadonlyMap<string, Point>,
    before: ReadonlyMap<string, [number, number]>,
  ): Corners =>
    Object.fromEntries(
      names
        .filter((name) => things.has(name))
        .map((name) => {
          const [x, y] = before.get(name) ?? [things.get(name)!.x, things.get(name)!.y]
          return [name, [Math.round(x + dx), Math.round(y + dy)]]
        }),
    )
  const tasks = goals(dot ? [] : pickedTasks(), boxes, bound.tasks)
  const loci = goals(dot ? [dot.svar] : lociWith(canvasState.document, pickedTasks()), dots, bound.loci)
  const ways = [
    [tasks, bound.tasks],
    [loci, bound.loci],
  ] as const
  if (!Object.keys({ ...tasks, ...loci }).length) return
  for (const [to, kept] of ways) for (const [name, corner] of Object.entries(to)) kept.set(name, corner)
  void move(tasks, loci).finally(() => {
    for (const [to, kept] of ways)
      for (const [name, corner] of Object.entries(to)) if (kept.get(name) === corner) kept.delete(name)
  })
}

export function openSheet(task: string): void {
  select(task)
  openDialog('sheet', { task })
}

export const openSource = (task: string, kind: 'code' | 'rmod'): void =>
  openDialog('source', { task: desk.task(task, canvas.doc)?.file || task, kind })

/** All rules and warnings (C26); what was found stands under Problems and is read out. */
export async function check(at?: Point): Promise<void> {
  const sentences = await act({ t: 'Check', doc: canvas.doc }, at)
  if (sentences === undefined) return
  canvas.strip = 'problems'
  announce(Array.isArray(sentences) && sentences.length ? sentences.join(' ') : t('canvas.checked'))
}

export function reconnect(): void {
  void act({ t: 'Connect', doc: canvas.doc })
}
