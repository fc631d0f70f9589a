// What the buttons of a mouse, a pen or fingers mean in the workspace (table B.4).
import { openDialog } from '../state/dialogs.svelte'
import { pickSteps, workspace, type Place } from '../state/workspace.svelte'
import { Press } from '../gesture/press'
import type { Gesture } from '../gesture/gesture'
import { skipMode } from '../run/skipMode.svelte'
import { workspaceState, type Over } from './workspaceState.svelte'
import {
  deselect,
  edit,
  editPicture,
  expand,
  goTo,
  insert,
  noteSteps,
  pickedSteps,
  placeBehind,
  placeOf,
  select,
  selectAlso,
  selectTo,
  whole,
  whyNotExpand,
} from './acts'
import { headOf } from '../application/actions'
import { gapAt } from '../application/gaps'
import { Dragging } from './dragging'
import { Marquee } from './marquee'

/** So long the press that inserts waits for its answer before it is shown itself. */
const SOON_MS = 50
let isInserting = false

type At = { x: number; y: number }
const at = (event: { clientX: number; clientY: number }): At => ({ x: event.clientX, y: event.clientY })

export function overOf(target: EventTarget | null): Over {
  const element = target instanceof Element ? target.closest<SVGElement>('[data-step], [data-flow]') : null
  const step = Number(element?.dataset.step ?? 0)
  if (step > 0) return { kind: 'step', step }
  return element?.dataset.flow === undefined ? { kind: 'ground' } : { kind: 'flow', flow: element.dataset.flow }
}

export class PointerGestures {
  private gesture: Gesture | undefined
  private pointer = -1
  /** The press under way has inserted something: the menu that the browser means by it does not come. */
  private hasInserted = false

  get isBusy(): boolean {
    return this.gesture !== undefined
  }

  down(event: PointerEvent): void {
    const over = overOf(event.target)
    this.hasInserted = event.button === 2 && event.pointerType === 'mouse' && inserts(event)
    if (!this.hasInserted) workspaceState.focus()
    if (event.button === 0 && pointsAtEnd(over)) return
    workspaceState.close()
    if (this.hasInserted) this.insert(event, over)
    if (this.gesture || event.button > 1) return
    this.pointer = event.pointerId
    this.gesture = event.button === 1 ? this.middle(event, over) : this.left(event, over)
  }

  move(event: PointerEvent): void {
    if (event.pointerId === this.pointer) this.gesture?.move(event)
  }

  up(event: PointerEvent): void {
    if (event.pointerId !== this.pointer) return
    const { gesture } = this
    this.gesture = undefined
    gesture?.up(event)
  }

  /** Esc, or the browser takes the pointer away: everything goes back. */
  cancel(): void {
    const { gesture } = this
    this.gesture = undefined
    gesture?.cancel()
  }

  double(event: MouseEvent): void {
    const over = overOf(event.target)
    if (over.kind === 'step') edit(over.step)
    else if (placeAt(at(event))) workspaceState.opened = { kind: 'quick', words: '' }
  }

  /** The right button inserts what is selected in the dictionary; without that, and by key or finger, it opens a menu. */
  context(event: MouseEvent): void {
    event.preventDefault()
    if (this.hasInserted) return void (this.hasInserted = false)
    this.cancel()
    const over = overOf(event.target)
    if (event.button === 2 && inserts(event)) return this.insert(event, over)
    placeBy(event, over)
    workspaceState.opened = { kind: 'menu', at: at(event), over }
  }

  /** When the button goes down, not when the browser would show its menu: that is later, on some systems when it is let go. */
  private insert(event: MouseEvent, over: Over): void {
    this.cancel()
    const place = over.kind === 'step' ? placeOf(over.step) : (gapNear(at(event)) ?? workspace.place)
    if (over.kind === 'step') noteSteps('select_icon', [over.step])
    void insertByPress(place, at(event), () => {
      placeBy(event, over)
      workspaceState.focus()
    }).then(() => workspaceState.focus())
  }

  private left(event: PointerEvent, over: Over): Gesture {
    if (over.kind === 'step') return this.leftOnStep(event, over.step)
    const adds = event.shiftKey || event.ctrlKey || event.metaKey
    const click = (): void => {
      if (!adds) deselect()
      placeAt(at(event))
    }
    return new Press(
      event,
      click,
      event.pointerType === 'touch' ? undefined : (first) => new Marquee(first, adds ? pickedSteps() : []),
    )
  }

  private leftOnStep(event: PointerEvent, step: number): Gesture {
    if (skipMode.isOn) return new Press(event, () => void skipMode.choose(headOf(workspaceState.actions, step)))
    if (event.shiftKey) return new Press(event, () => (whyNotExpand(step) ? selectTo(step) : void expand(step)))
    if (event.ctrlKey || event.metaKey)
      return new Press(
        event,
        () => selectAlso(step),
        (first) => new Dragging(liftedWith(step), first),
      )
    const click = (): void => {
      if (nearLeftSide(event)) return (pickSteps(), void placeAt(at(event)))
      select(step)
    }
    const canDrag = event.pointerType !== 'touch' && !workspaceState.isRunning
    return new Press(event, click, canDrag ? (first) => new Dragging(liftedWith(step), first) : undefined)
  }

  private middle(event: PointerEvent, over: Over): Gesture | undefined {
    if (over.kind !== 'step') return undefined
    const { step } = over
    return new Press(event, () => {
      if (event.shiftKey) editPicture(step)
      else if (workspaceState.step(step)?.role === 'target') openDialog('icon', { step: String(step) })
      else workspaceState.opened = { kind: 'facts', step }
    })
  }
}

/** What goes along when a step is dragged: all that is picked, and with each job its targets. */
function liftedWith(step: number): number[] {
  const steps = workspace.steps.has(step) ? pickedSteps() : [step]
  return [
    ...new Set(
      steps.flatMap((number) => (headOf(workspaceState.actions, number) === number ? whole(number) : [number])),
    ),
  ]
}

/** While a loop looks for its other end, a click on an action is it. */
function pointsAtEnd(over: Over): boolean {
  const { opened } = workspaceState
  if (opened.kind !== 'loop' || over.kind !== 'step') return false
  const other = headOf(workspaceState.actions, over.step)
  if (other !== opened.step) workspaceState.opened = { ...opened, other }
  return true
}

/** Put the insertion cursor where the pointer is; false where there is no place near. */
function placeAt(point: At): boolean {
  const gap = gapNear(point)
  if (gap) goTo(gap)
  return gap !== undefined
}

/** The place between icons where the pointer is. */
function gapNear(point: At): Place | undefined {
  const { x, y } = workspaceState.toPaper(point)
  return gapAt(workspaceState.base.gaps, x, y, workspaceState.size)
}

/** Whether the right button inserts now; not while it does so. */
const inserts = (event: MouseEvent): boolean => workspace.onikon !== '' && !event.shiftKey && !isInserting

/**
 * What is selected in the dictionary goes into a place, and is selected no more; refused, it stays so. Nothing of the press
 * is drawn before the answer where that comes soon: a browser first paints what a press has changed, and hears the answer
 * only then. `show` shows where the press was: where it is refused, or the answer comes late.
 */
async function insertByPress(place: Place, point: At, show: () => void): Promise<void> {
  const { onikon } = workspace
  const putAway = (): void => {
    isInserting = false
    if (workspace.onikon === onikon) workspace.onikon = ''
  }
  const late = setTimeout(() => (putAway(), show()), SOON_MS)
  isInserting = true
  const wentWell = await insert(onikon, place, point)
  clearTimeout(late)
  putAway()
  if (wentWell) return
  workspace.onikon ||= onikon
  show()
}

/** Put the insertion cursor behind the icon that is pointed at, or between icons. */
function placeBy(event: MouseEvent, over: Over): void {
  if (over.kind !== 'step') placeAt(at(event))
  else if (workspace.steps.has(over.step)) placeBehind(over.step)
  else select(over.step)
}

/** A click on the outermost left of an icon means the gap before it. */
function nearLeftSide(event: PointerEvent): boolean {
  const cell = event.target instanceof Element ? event.target.closest<SVGGElement>('[data-step]') : null
  const step = Number(cell?.dataset.step ?? 0)
  const x = workspaceState.cells.get(step)?.x
  return x !== undefined && workspaceState.toPaper(at(event)).x < x + 7
}
