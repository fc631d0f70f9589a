// What the buttons of a mouse, a pen or fingers mean on the canvas (table B.2).
import { canvas } from '../state/canvas.svelte'
import {
  check,
  deselect,
  note,
  openSheet,
  openSource,
  pickedTasks,
  placeAt,
  selectLocus,
  toggle,
  toggleLines,
  togglePin,
} from '../scene/acts'
import { DragBoxes, DragDot } from './dragging'
import type { Gesture } from '../gesture/gesture'
import { overOf } from '../scene/over'
import { selectAlsoAll, selectAs, selectGroup, toggleGroup, wholeOf } from '../group/grouping'
import { lociWith, membersOf } from '../scene/groups'
import { Marquee } from './marquee'
import { Pan, Pinch } from './panning'
import { Press } from '../gesture/press'
import { canvasState, type Over } from '../scene/canvasState.svelte'

type At = { x: number; y: number }
const at = (event: { clientX: number; clientY: number }): At => ({ x: event.clientX, y: event.clientY })

export class PointerGestures {
  private gesture: Gesture | undefined
  private readonly fingers = new Map<number, PointerEvent>()

  get isBusy(): boolean {
    return this.gesture !== undefined
  }

  down(event: PointerEvent): void {
    canvasState.close()
    this.fingers.set(event.pointerId, event)
    if (this.fingers.size === 2 && event.pointerType === 'touch') {
      this.gesture?.cancel()
      this.gesture = new Pinch(...([...this.fingers.values()] as [PointerEvent, PointerEvent]))
    } else if (!this.gesture) this.gesture = this.begin(event, overOf(event.target))
  }

  move(event: PointerEvent): void {
    if (this.fingers.has(event.pointerId)) this.gesture?.move(event)
  }

  up(event: PointerEvent): void {
    if (!this.fingers.delete(event.pointerId)) return
    const { gesture } = this
    this.gesture = undefined
    gesture?.up(event)
  }

  /** Esc, or the browser takes the pointer away: everything goes back. */
  cancel(): void {
    this.fingers.clear()
    const { gesture } = this
    this.gesture = undefined
    gesture?.cancel()
  }

  double(event: MouseEvent): void {
    const over = overOf(event.target)
    if (over.kind === 'task') openSheet(over.name)
    else if (over.kind === 'locus') canvasState.opened = { kind: 'locus', at: at(event), svar: over.name }
    else if (over.kind === 'ground') canvasState.opened = { kind: 'quick', at: at(event) }
  }

  /** The right button places what is selected in the library; without that, and by key or finger, it opens a menu. */
  context(event: MouseEvent): void {
    event.preventDefault()
    this.cancel()
    const over = overOf(event.target)
    if (event.button === 2 && canvas.libraryTask) return placeAt(canvas.libraryTask, at(event), false)
    if (over.kind === 'task' && !canvas.picked.has(over.name)) selectAs(wholeOf(over.name), `task:${over.name}`)
    if (over.kind === 'group') selectGroup(over.name)
    if (over.kind === 'locus') selectLocus(over.name)
    canvasState.opened = { kind: 'menu', at: at(event), over }
  }

  private begin(event: PointerEvent, over: Over): Gesture | undefined {
    if (event.button === 0 && canvasState.isSpaceDown) return new Pan(event)
    if (event.button === 0) return this.left(event, over)
    return event.button === 1 ? this.middle(event, over) : undefined
  }

  private left(event: PointerEvent, over: Over): Gesture {
    if (over.kind === 'task') return this.leftOnTask(event, over.name)
    if (over.kind === 'locus') return this.leftOnLocus(event, over.name)
    if (over.kind === 'group') return this.leftOnGroup(event, over.name)
    const adds = event.shiftKey || event.ctrlKey || event.metaKey
    const marquee = (first: PointerEvent): Gesture => new Marquee(first, adds ? pickedTasks() : [])
    return new Press(
      event,
      () => adds || deselect(),
      event.pointerType === 'touch' ? (first) => new Pan(first) : marquee,
    )
  }

  private leftOnTask(event: PointerEvent, name: string): Gesture {
    if (event.shiftKey) return new Press(event, () => toggle(name, at(event)))
    const [all, focus] = [wholeOf(name), `task:${name}`]
    const isOne = event.altKey && all.length > 1
    const meant = isOne ? [name] : all
    if (event.ctrlKey || event.metaKey) return new Press(event, () => selectAlsoAll(meant, focus))
    const wasPicked = !isOne && all.every((task) => canvas.picked.has(task))
    if (!wasPicked) selectAs(meant, focus)
    canvasState.focus = focus
    return new Press(
      event,
      () => wasPicked && selectAs(meant, focus),
      (first) => new DragBoxes(name, pickedTasks(), lociWith(canvasState.document, pickedTasks()), first),
    )
  }

  private leftOnGroup(event: PointerEvent, group: string): Gesture {
    if (event.shiftKey) return new Press(event, () => toggleGroup(group, at(event)))
    const all = membersOf(canvasState.document, group)
    if (event.ctrlKey || event.metaKey) return new Press(event, () => selectAlsoAll(all, `group:${group}`))
    const wasPicked = all.every((task) => canvas.picked.has(task))
    if (!wasPicked) selectGroup(group)
    canvasState.focus = `group:${group}`
    const grabbed = all.find((task) => canvasState.scene.boxes.has(task)) ?? ''
    return new Press(
      event,
      () => wasPicked && selectGroup(group),
      (first) => new DragBoxes(grabbed, pickedTasks(), lociWith(canvasState.document, pickedTasks()), first),
    )
  }

  private leftOnLocus(event: PointerEvent, svar: string): Gesture {
    if (event.shiftKey) return new Press(event, () => toggleLines(svar))
    selectLocus(svar)
    const isOnCanvas = canvasState.scene.dots.has(svar)
    return new Press(
      event,
      () => clickLocus(svar, isOnCanvas),
      () => (isOnCanvas ? new DragDot(svar) : undefined),
    )
  }

  private middle(event: PointerEvent, over: Over): Gesture {
    if (over.kind === 'task') return new Press(event, () => middleOnTask(event, over.name))
    if (event.shiftKey) return new Press(event, () => void check(at(event)))
    if (over.kind === 'locus')
      return new Press(event, () => (canvasState.opened = { kind: 'locus', at: at(event), svar: over.name }))
    return new Press(
      event,
      () => undefined,
      (first) => new Pan(first),
    )
  }
}

function middleOnTask(event: PointerEvent, name: string): void {
  if (event.shiftKey) openSource(name, 'code')
  else if (event.ctrlKey || event.metaKey) openSource(name, 'rmod')
  else openSheet(name)
}

/** A click on a dot pins what it carries; on one of the row of constants it brings the lines out. */
function clickLocus(svar: string, isOnCanvas: boolean): void {
  note('select_locus', svar)
  if (isOnCanvas) togglePin(svar)
  else toggleLines(svar)
}
