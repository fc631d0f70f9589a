// A press that is not yet anything else: it becomes a click when let go, or another gesture once the pointer moves.
import { hasMoved, type Gesture } from './gesture'

export class Press implements Gesture {
  private become: Gesture | undefined
  private readonly from: { x: number; y: number }

  /** `click` where the pointer stays; `drag` gives what a movement begins, if anything. */
  constructor(
    private readonly first: PointerEvent,
    private readonly click: (event: PointerEvent) => void,
    private readonly drag: (first: PointerEvent) => Gesture | undefined = () => undefined,
  ) {
    this.from = { x: first.clientX, y: first.clientY }
  }

  move(event: PointerEvent): void {
    if (!this.become && hasMoved(this.from, event)) this.become = this.drag(this.first) ?? STILL
    this.become?.move(event)
  }

  up(event: PointerEvent): void {
    if (this.become) this.become.up(event)
    else this.click(event)
  }

  cancel(): void {
    this.become?.cancel()
  }
}

/** A movement that means nothing; it is no click either. */
const STILL: Gesture = { move: () => undefined, up: () => undefined, cancel: () => undefined }
