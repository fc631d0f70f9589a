// A rectangle drawn on empty canvas picks what it touches.
import { pick } from '../state/canvas.svelte'
import { areaOf, type Rect } from '../geom/rect'
import type { Gesture } from '../gesture/gesture'
import { wholeOf } from '../group/grouping'
import { note, pickedTasks } from '../scene/acts'
import { canvasState } from '../scene/canvasState.svelte'

export class Marquee implements Gesture {
  private readonly start: readonly [number, number]

  /** `before` stays picked: with Shift or Ctrl a rectangle adds. */
  constructor(
    first: PointerEvent,
    private readonly before: readonly string[],
  ) {
    this.start = canvasState.view.toScene(first.clientX, first.clientY)
  }

  move(event: PointerEvent): void {
    const rect = between(this.start, canvasState.view.toScene(event.clientX, event.clientY))
    canvasState.marquee = rect
    pick(...this.before, ...wholeOf(...canvasState.scene.boxesIn(areaOf(rect)).map((box) => box.name)))
  }

  up(): void {
    canvasState.marquee = undefined
    note('select_icons', ...pickedTasks())
  }

  cancel(): void {
    canvasState.marquee = undefined
    pick(...this.before)
  }
}

const between = ([ax, ay]: readonly [number, number], [bx, by]: readonly [number, number]): Rect => ({
  x: Math.min(ax, bx),
  y: Math.min(ay, by),
  w: Math.abs(ax - bx),
  h: Math.abs(ay - by),
})
