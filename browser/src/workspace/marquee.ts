// A rectangle drawn on empty ground picks what it touches.
import { pickSteps } from '../state/workspace.svelte'
import type { Gesture } from '../gesture/gesture'
import { board } from './board.svelte'
import { edgeScroll } from './scrolling'

export class Marquee implements Gesture {
  private readonly start: { x: number; y: number }

  /** `before` stays picked: with Shift or Ctrl a rectangle adds. */
  constructor(first: PointerEvent, private readonly before: readonly number[]) {
    this.start = board.toPaper({ x: first.clientX, y: first.clientY })
  }

  move(event: PointerEvent): void {
    const { x, y } = board.toPaper({ x: event.clientX, y: event.clientY })
    const area = { x: Math.min(x, this.start.x), y: Math.min(y, this.start.y), w: Math.abs(x - this.start.x), h: Math.abs(y - this.start.y) }
    board.marquee = area
    const touched = board.base.cells.filter(
      (cell) => cell.step > 0 && cell.x < area.x + area.w && cell.x + cell.w > area.x && cell.y < area.y + area.h && cell.y + board.size > area.y,
    )
    pickSteps(...this.before, ...touched.map((cell) => cell.step))
    edgeScroll(event)
  }

  up(): void {
    board.marquee = undefined
  }

  cancel(): void {
    board.marquee = undefined
    pickSteps(...this.before)
  }
}
