// What a user can do in the workspace, whether by hand, key or menu. Each sends one act; the environment decides.
import { act } from '../act/act'
import { announce } from '../state/announce'
import { desk } from '../link/desk.svelte'
import { openDialog } from '../state/dialogs.svelte'
import { look } from '../state/look.svelte'
import { pickSteps, workspace, type Place } from '../state/workspace.svelte'
import { note } from '../link/note'
import type { Point } from '../act/refused.svelte'
import { goInto, lookInto, open } from '../act/opening'
import { subsystemAt } from '../progress/inside'
import { isHeldToWords } from '../onikon/presentation'
import { t } from '../texts/index.svelte'
import { flowOf, headOf, inReadingOrder, wholeOf } from '../application/actions'
import { workspaceState } from './workspaceState.svelte'
import { gapOf } from '../application/gaps'
import { flowName, nameOf } from '../application/words'

/** The text that was copied last here: the environment still has it in its buffer. */
let copied = ''

export const pickedSteps = (): number[] => inReadingOrder(workspaceState.app, workspace.steps)

/** The steps that are meant: those picked, else the one that the cursor stands behind. */
export function meant(): number[] {
  const picked = pickedSteps()
  return picked.length ? picked : workspaceState.step(workspace.place.after) ? [workspace.place.after] : []
}

/** The actions that are meant, by their jobs: marks are theirs. */
export const meantHeads = (): number[] =>
  [...new Set(meant().map((step) => headOf(workspaceState.actions, step)))].filter(
    (step) => (workspaceState.step(step)?.kind ?? 'icon') === 'icon',
  )

export function select(step: number): void {
  pickSteps(step)
  placeBehind(step)
  noteSteps('select_icon', [step])
}

/** What this page alone knows of steps: which are picked, which were dragged and put back (H01). */
export function noteSteps(event: string, steps: readonly number[]): void {
  const names = steps.map((step) => workspaceState.step(step)?.name ?? '')
  note(event, names.join(','), steps.map((step) => `${workspace.app}/${step}`).join(','), 'appl')
}

export function selectAlso(step: number): void {
  if (!workspace.steps.delete(step)) workspace.steps.add(step)
  placeBehind(step)
}

/** All from the cursor's step to this one, where both stand in one flow. */
export function selectTo(step: number): void {
  const flow = flowOf(workspaceState.app, step)
  const steps = workspaceState.app?.flows?.[flow]?.steps ?? []
  const [from, to] = [Math.max(0, steps.indexOf(workspace.place.after)), steps.indexOf(step)]
  for (const number of steps.slice(Math.min(from, to), Math.max(from, to) + 1)) workspace.steps.add(number)
}

export function selectAll(): void {
  const flow = workspace.place.flow in (workspaceState.app?.flows ?? {}) ? workspace.place.flow : '0'
  pickSteps(...(workspaceState.app?.flows?.[flow]?.steps ?? []))
}

export const deselect = (): void => pickSteps()

/** The place behind a step; a hole stands for the step before it (reading 33). */
export function placeOf(step: number): Place {
  const flow = flowOf(workspaceState.app, step)
  const steps = workspaceState.app?.flows?.[flow]?.steps ?? []
  const after = workspaceState.step(step)?.kind === 'hole' ? (steps[steps.indexOf(step) - 1] ?? 0) : step
  return { flow, after }
}

export const placeBehind = (step: number): void => void (workspace.place = placeOf(step))

/** Put the insertion cursor somewhere, and bring it into view. */
export function goTo(place: Place, isSaid = false): void {
  workspace.place = { flow: place.flow, after: place.after }
  showPlace(place)
  if (isSaid) announce(readPlace(place))
}

/** The place of the insertion cursor in words, as it is read out when the cursor comes there. */
function readPlace({ flow, after }: Place): string {
  const step = workspaceState.step(after)
  return step ? t('upper.behind', { name: nameOf(step) }) : t('upper.atStart', { flow: flowName(flow) })
}

export function showPlace(place: Place): void {
  const gap = gapOf(workspaceState.shown.gaps, place)
  if (gap) workspaceState.show(gap.y)
}

/** Insert an icon of a dictionary; the cursor moves on behind it. True where it went well. */
export async function insert(
  onikon: string,
  place: Place = workspace.place,
  at: Point = windowPoint(place),
): Promise<boolean> {
  const { flow, after } = place
  const step = await act({ t: 'InsertIcon', doc: workspace.app, onikon, flow, after }, at)
  if (step === undefined) return false
  if (typeof step === 'number') arrive(flow, step)
  announce(t('upper.inserted', { name: nameOf(workspaceState.step(Number(step))) || onikon }))
  return true
}

/**
 * What is selected in the dictionary goes into a place, and is selected no more; refused, it is again. What was selected
 * there while the answer was on its way stays so.
 */
export async function insertSelected(onikon: string, slot: Place & { replaces?: number }, at: Point): Promise<void> {
  workspace.onikon = ''
  const wentWell = await (slot.replaces ? exchange(slot.replaces, onikon, at) : insert(onikon, slot, at))
  if (!wentWell) workspace.onikon ||= onikon
}

function arrive(flow: string, step: number): void {
  deselect()
  goTo({ flow, after: step })
}

/** Where a place is in the window: a refusal stands beside it. */
export function windowPoint(place: Place): Point {
  const gap = gapOf(workspaceState.shown.gaps, place)
  return workspaceState.toWindow(gap ? { x: gap.x + 12, y: gap.y + workspaceState.size } : { x: 40, y: 40 })
}

const stepPoint = (step: number): Point | undefined => {
  const cell = workspaceState.cells.get(step)
  return cell && workspaceState.toWindow({ x: cell.x + cell.w, y: cell.y + workspaceState.size })
}

export async function remove(steps = meant()): Promise<void> {
  if (!steps.length) return
  const place = placeWithout(steps)
  if ((await act({ t: 'RemoveIcons', doc: workspace.app, steps }, stepPoint(steps[0]!))) !== undefined) left(place)
}

/** Where the cursor is when these are gone: behind what stood before the first of them. */
function placeWithout(steps: readonly number[]): Place {
  const flow = flowOf(workspaceState.app, steps[0]!)
  const all = workspaceState.app?.flows?.[flow]?.steps ?? []
  const before = all.slice(0, all.indexOf(steps[0]!)).filter((number) => workspaceState.step(number)?.kind !== 'hole')
  return { flow, after: before.at(-1) ?? 0 }
}

function left(place: Place): void {
  deselect()
  goTo(place)
}

/** Steps done so many times: a job that counts comes behind them, as one step that Undo takes back. */
export const repeat = (steps: readonly number[], times: number, at?: Point): Promise<unknown> =>
  act(
    { t: 'RepeatSteps', doc: workspace.app, steps: [...steps], times, description: t('upper.times', { n: times }) },
    at,
  )

/** The form of a loop: both its ends where several actions are selected, else the one, and the other is pointed at. */
export function askForLoop(heads = meantHeads()): void {
  const [first = 0] = heads
  workspaceState.opened = { kind: 'loop', step: heads.at(-1) ?? 0, other: heads.length > 1 ? first : 0 }
}

export const askHowOften = (steps = meant()): void => void (workspaceState.opened = { kind: 'repeat', steps })

export async function copy(steps = meant()): Promise<void> {
  if (steps.length) takeText(await act({ t: 'CopyIcons', doc: workspace.app, steps }))
}

/** What Delete does to what is picked (table B.4): it goes into the buffer. */
export async function cut(steps = meant()): Promise<void> {
  if (!steps.length) return
  const place = placeWithout(steps)
  const text = await act({ t: 'CutIcons', doc: workspace.app, steps }, stepPoint(steps[0]!))
  if (text === undefined) return
  takeText(text)
  left(place)
}

/** Behind what is selected; with nothing selected, at the cursor. */
function placeBehindPicked(): Place {
  const last = pickedSteps().at(-1)
  return last ? { flow: flowOf(workspaceState.app, last), after: last } : workspace.place
}

export async function paste(text = '', place: Place = placeBehindPicked()): Promise<void> {
  const { flow, after } = place
  const numbers = await act(
    { t: 'PasteIcons', doc: workspace.app, flow, after, text: text === copied ? '' : text },
    windowPoint(place),
  )
  if (Array.isArray(numbers) && typeof numbers.at(-1) === 'number') arrive(flow, numbers.at(-1) as number)
}

/** The text of what was copied also goes to the system's clipboard, where the browser allows it. */
function takeText(text: unknown): void {
  if (typeof text !== 'string') return
  copied = text
  void navigator.clipboard?.writeText(text).catch(() => undefined)
}

export async function move(steps: readonly number[], slot: Place & { replaces?: number }, at?: Point): Promise<void> {
  const { flow, after, replaces } = slot
  const inPlace = replaces ? { replaces } : {}
  const moved = await act({ t: 'MoveIcons', doc: workspace.app, steps: [...steps], flow, after, ...inPlace }, at)
  if (moved !== undefined) goTo({ flow, after: steps.at(-1) ?? after })
}

/** Another icon in the place of a step; it is selected then. True where it went well. */
export async function exchange(step: number, onikon: string, at?: Point): Promise<boolean> {
  if ((await act({ t: 'ExchangeIcon', doc: workspace.app, step, onikon }, at ?? stepPoint(step))) === undefined)
    return false
  select(step)
  announce(t('upper.replaced', { name: nameOf(workspaceState.step(step)) || onikon }))
  return true
}

/** The step that another icon may come in place of: the one that is meant, where it is an icon. */
export function replaceable(): number {
  const [step = 0, ...others] = meant()
  const view = workspaceState.step(step)
  return view && !others.length && (view.kind ?? 'icon') === 'icon' ? step : 0
}

/** Look for what comes in place of a step. */
export const askForOther = (step = replaceable()): void =>
  void (workspaceState.opened = { kind: 'quick', words: '', replaces: step })

/** Copies of steps behind another one, as one who drags with Ctrl means. */
export async function copyTo(steps: readonly number[], { flow, after }: Place, at?: Point): Promise<void> {
  const text = await act({ t: 'CopyIcons', doc: workspace.app, steps: [...steps] }, at)
  if (text === undefined) return
  takeText(text)
  await act({ t: 'PasteIcons', doc: workspace.app, flow, after }, at)
}

/** Set the breakpoint of the actions meant, or take it away where all have it. */
export function turnBreakpoint(steps = meantHeads()): void {
  if (!steps.length) return
  const areSet = steps.every((step) => workspaceState.step(step)?.breaks)
  void act({ t: 'SetBreakpoint', doc: workspace.app, steps, is_set: !areSet }, stepPoint(steps[0]!))
}

export function edit(step: number): void {
  const view = workspaceState.step(step)
  if (!view) return
  if (view.kind === 'hole') quickAt(step)
  else if (view.kind === 'branch') workspaceState.opened = { kind: 'branch', step }
  else openDialog('icon', { step: String(step) })
}

export const editPicture = (step: number): void =>
  openDialog('icon', { step: String(step), tab: isHeldToWords() ? 'what' : 'picture' })

/** Look for what fits into a hole. */
export function quickAt(hole: number): void {
  placeBehind(hole)
  workspaceState.opened = { kind: 'quick', words: '' }
}

/**
 * Show what stands behind an icon (D12): an application in its tab; a configuration at the lower level, in the place of a
 * live one, or as it lives where its application runs.
 */
export async function expand(step: number): Promise<void> {
  const view = workspaceState.step(step)
  const name = view?.name ?? ''
  if (!view || !name) return
  const path = desk.tree.onikons[name]?.source || name
  if (view.role === 'application') await open(path)
  else if (view.role === 'job') {
    const subsystem = desk.live.run?.doc === workspace.app && !desk.live.review ? subsystemAt(step) : ''
    await (subsystem ? lookInto(path, subsystem) : goInto(path))
  }
}

/** Why a step cannot be expanded; empty: it can. */
export function whyNotExpand(step: number): string {
  const role = workspaceState.step(step)?.role
  if (role !== 'job' && role !== 'application') return t('upper.nothingBehind')
  return role === 'job' && look.isUpperOnly ? t('upper.isUpperOnly') : ''
}

export const whole = (step: number): readonly number[] => wholeOf(workspaceState.actions, step)

export const addFlow = (step = 0): unknown => act({ t: 'AddFlow', doc: workspace.app, step })
export const removeFlow = (flow: string): unknown => act({ t: 'RemoveFlow', doc: workspace.app, flow })
export const setParallel = (isParallel: boolean): unknown =>
  act({ t: 'SetParallel', doc: workspace.app, is_parallel: isParallel })
