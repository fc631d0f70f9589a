// Boxes or a dot under the pointer. They go where the hand goes, in line with their neighbours; one step when let go.
import { areaOf, grown, overlaps } from '../geom/rect'
import { snap, type Snappable } from '../geom/snap'
import { canvas } from '../state/canvas.svelte'
import { move, note, onGrid } from '../scene/acts'
import type { Gesture } from '../gesture/gesture'
import type { Box, Dot } from '../scene/scene.svelte'
import { canvasState } from '../scene/canvasState.svelte'

interface Corner {
  x: number
  y: number
}

/** Boxes farther away are nobody's neighbours: to be in line with them would be chance. */
const NEAR_PX = 320

const snappable = (box: Box): Snappable => ({ ...box.rect, rows: box.pins.map((pin) => pin.y) })

export class DragBoxes implements Gesture {
  private readonly scene = canvasState.scene
  private readonly from = new Map<Box, Corner>()
  private readonly fromDot = new Map<Dot, Corner>()
  private readonly neighbours: Snappable[]
  private readonly grabbed: Box
  private readonly start: readonly [number, number]

  /** `svars`: the dots that go with these boxes. */
  constructor(
    name: string,
    names: Iterable<string>,
    svars: Iterable<string>,
    event: { clientX: number; clientY: number },
  ) {
    this.grabbed = this.scene.boxes.get(name)!
    for (const name of names) {
      const box = this.scene.boxes.get(name)
      if (!box) continue
      this.from.set(box, { x: box.x, y: box.y })
      box.isHeld = true
    }
    for (const svar of svars) {
      const dot = this.scene.dots.get(svar)
      if (!dot) continue
      this.fromDot.set(dot, { x: dot.x, y: dot.y })
      dot.isHeld = true
    }
    this.neighbours = this.scene
      .boxesIn(canvasState.view.area)
      .filter((box) => !this.from.has(box))
      .map(snappable)
    this.start = canvasState.view.toScene(event.clientX, event.clientY)
    canvasState.isHolding = true
  }

  move(event: PointerEvent): void {
    const [x, y] = canvasState.view.toScene(event.clientX, event.clientY)
    const from = this.from.get(this.grabbed)!
    const wished = { ...snappable(this.grabbed), x: from.x + x - this.start[0], y: from.y + y - this.start[1] }
    const near = grown(areaOf(wished), NEAR_PX)
    const neighbours = this.neighbours.filter((other) => overlaps(areaOf(other), near))
    const rest = snap(wished, neighbours, { suspended: event.altKey, reach: 4 / canvasState.view.scale })
    canvasState.guides = rest.guides
    this.put(Math.round(rest.x - from.x), Math.round(rest.y - from.y))
  }

  up(): void {
    canvasState.guides = []
    canvasState.isHolding = false
    const moved: Record<string, [number, number]> = {}
    for (const [box, from] of this.from) if (box.x !== from.x || box.y !== from.y) moved[box.name] = [box.x, box.y]
    const dots: Record<string, [number, number]> = {}
    for (const [dot, from] of this.fromDot) if (dot.x !== from.x || dot.y !== from.y) dots[dot.svar] = [dot.x, dot.y]
    if (Object.keys(moved).length || Object.keys(dots).length)
      note('end_drag', ...Object.keys(moved), ...Object.keys(dots))
    if (Object.keys(moved).length) void move(moved, dots).finally(() => this.release())
    else this.release()
  }

  cancel(): void {
    note('cancel_drag', ...[...this.from.keys()].map((box) => box.name))
    canvasState.guides = []
    canvasState.isHolding = false
    this.put(0, 0)
    this.release()
  }

  private put(dx: number, dy: number): void {
    for (const [box, from] of this.from) this.scene.hold(box.name, from.x + dx, from.y + dy)
    for (const [dot, from] of this.fromDot) this.scene.holdDot(dot.svar, from.x + dx, from.y + dy)
    this.scene.redraw()
  }

  /** From now on they stand where the document says, which has the move by now or has refused it. */
  private release(): void {
    for (const held of [...this.from.keys(), ...this.fromDot.keys()]) held.isHeld = false
    canvasState.turn += 1
  }
}

/** A variable is plotted by dropping its dot there; the dot itself goes back. */
const isOverPlots = (event: PointerEvent): boolean =>
  document.elementFromPoint(event.clientX, event.clientY)?.closest('[data-drop="plots"]') != null

export class DragDot implements Gesture {
  private readonly scene = canvasState.scene
  private readonly from: Corner
  private readonly seen = canvasState.view.seen

  constructor(private readonly svar: string) {
    const dot = this.scene.dots.get(svar)!
    dot.isHeld = true
    this.from = { x: dot.x, y: dot.y }
    canvasState.isHolding = canvasState.isForBelow = true
  }

  move(event: PointerEvent): void {
    const [x, y] = canvasState.view.toScene(event.clientX, event.clientY)
    this.put(event.altKey ? Math.round(x) : onGrid(x), event.altKey ? Math.round(y) : onGrid(y))
  }

  up(event: PointerEvent): void {
    const { clientX: x, clientY: y } = event
    if (isOverPlots(event)) {
      canvas.plots = [...new Set([...canvas.plots, this.svar])]
      note('plot_locus', this.svar)
      return this.takeBack()
    }
    if (!canvasState.view.holds(x, y)) {
      note('cancel_drag', this.svar)
      return this.takeBack()
    }
    canvasState.isHolding = canvasState.isForBelow = false
    const dot = this.scene.dots.get(this.svar)
    if (!dot || (dot.x === this.from.x && dot.y === this.from.y)) return this.release()
    note('end_drag', this.svar)
    void move({}, { [this.svar]: [dot.x, dot.y] }).finally(() => this.release())
  }

  cancel(): void {
    note('cancel_drag', this.svar)
    this.putBack()
  }

  private putBack(): void {
    canvasState.isHolding = canvasState.isForBelow = false
    this.put(this.from.x, this.from.y)
    this.release()
  }

  /** Let go off the canvas: dot and paper are where they were before. */
  private takeBack(): void {
    canvasState.view.seen = this.seen
    this.putBack()
  }

  private put(x: number, y: number): void {
    this.scene.holdDot(this.svar, x, y)
    this.scene.redraw()
  }

  private release(): void {
    const dot = this.scene.dots.get(this.svar)
    if (dot) dot.isHeld = false
    canvasState.turn += 1
  }
}
