// A rectangle drawn on empty ground picks what it touches.
import { pickSteps, workspace } from '../state/workspace.svelte'
import type { Gesture } from '../gesture/gesture'
import { workspaceState } from './workspaceState.svelte'
import { noteSteps } from './acts'
import { edgeScroll } from './scrolling'

export class Marquee implements Gesture {
  private readonly start: { x: number; y: number }

  /** `before` stays picked: with Shift or Ctrl a rectangle adds. */
  constructor(
    first: PointerEvent,
    private readonly before: readonly number[],
  ) {
    this.start = workspaceState.toPaper({ x: first.clientX, y: first.clientY })
  }

  move(event: PointerEvent): void {
    const { x, y } = workspaceState.toPaper({ x: event.clientX, y: event.clientY })
    const area = {
      x: Math.min(x, this.start.x),
      y: Math.min(y, this.start.y),
      w: Math.abs(x - this.start.x),
      h: Math.abs(y - this.start.y),
    }
    workspaceState.marquee = area
    const touched = workspaceState.base.cells.filter(
      (cell) =>
        cell.step > 0 &&
        cell.x < area.x + area.w &&
        cell.x + cell.w > area.x &&
        cell.y < area.y + area.h &&
        cell.y + workspaceState.size > area.y,
    )
    pickSteps(...this.before, ...touched.map((cell) => cell.step))
    edgeScroll(event)
  }

  up(): void {
    workspaceState.marquee = undefined
    noteSteps('select_icons', [...workspace.steps])
  }

  cancel(): void {
    workspaceState.marquee = undefined
    pickSteps(...this.before)
  }
}
