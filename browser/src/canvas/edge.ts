// What is dragged to the edge of the canvas draws the paper along.
import { canvasState } from '../scene/canvasState.svelte'

/** How near the edge, and how far at most with each picture of the screen. */
const NEAR_PX = 28
const MOST_PX = 14
/** Farther beyond, the pointer is on its way to something else. */
const BEYOND_PX = 24

/** How far the paper moves along one direction when the pointer is at a place between the two edges. */
export function pull(at: number, from: number, to: number): number {
  const [low, high] = [at - from, to - at]
  if (Math.min(low, high) < -BEYOND_PX) return 0
  const depth = Math.min(1, (NEAR_PX - Math.min(low, high)) / NEAR_PX)
  if (depth <= 0) return 0
  return Math.round(MOST_PX * depth) * (low < high ? 1 : -1)
}

export class Edge {
  private frame = 0
  private last: PointerEvent | undefined

  /** The pointer is here now; while it stays at the edge, `again` is told of the same place on moved paper. */
  follow(event: PointerEvent, again: (event: PointerEvent) => void): void {
    this.last = event
    if (!this.frame && this.step()) this.frame = requestAnimationFrame(() => this.go(again))
  }

  stop(): void {
    cancelAnimationFrame(this.frame)
    this.frame = 0
  }

  private go(again: (event: PointerEvent) => void): void {
    this.frame = 0
    const step = this.step()
    if (!step || !this.last) return
    canvasState.view.pan(...step)
    again(this.last)
    this.frame = requestAnimationFrame(() => this.go(again))
  }

  private step(): [number, number] | undefined {
    if (!this.last || !(canvasState.isHolding || canvasState.marquee)) return undefined
    const { left, top, size } = canvasState.view
    const { clientX: x, clientY: y } = this.last
    if (canvasState.isForBelow && y > top + size.h - NEAR_PX) return undefined
    const step: [number, number] = [pull(x, left, left + size.w), pull(y, top, top + size.h)]
    return step[0] || step[1] ? step : undefined
  }
}
