// The hand moves the paper: with one pointer, or with two that also scale it.
import type { Gesture } from '../gesture/gesture'
import { canvasState } from '../scene/canvasState.svelte'

export class Pan implements Gesture {
  private last: { x: number; y: number }

  constructor(first: PointerEvent) {
    this.last = { x: first.clientX, y: first.clientY }
    canvasState.isPanning = true
  }

  move({ clientX: x, clientY: y }: PointerEvent): void {
    canvasState.view.pan(x - this.last.x, y - this.last.y)
    this.last = { x, y }
  }

  up(): void {
    canvasState.isPanning = false
  }

  cancel(): void {
    canvasState.isPanning = false
  }
}

/** Two fingers: what lies under them stays under them. */
export class Pinch implements Gesture {
  private readonly at = new Map<number, { x: number; y: number }>()

  constructor(first: PointerEvent, second: PointerEvent) {
    for (const finger of [first, second]) this.at.set(finger.pointerId, { x: finger.clientX, y: finger.clientY })
  }

  move(event: PointerEvent): void {
    if (!this.at.has(event.pointerId)) return
    const before = this.shape()
    this.at.set(event.pointerId, { x: event.clientX, y: event.clientY })
    const now = this.shape()
    canvasState.view.pan(now.x - before.x, now.y - before.y)
    if (before.apart > 0) canvasState.view.zoom(now.apart / before.apart, now.x, now.y)
  }

  up(): void {}

  cancel(): void {}

  private shape(): { x: number; y: number; apart: number } {
    const [a, b] = [...this.at.values()] as [{ x: number; y: number }, { x: number; y: number }]
    return { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2, apart: Math.hypot(a.x - b.x, a.y - b.y) }
  }
}
