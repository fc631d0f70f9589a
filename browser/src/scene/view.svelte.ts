// Which part of the canvas is seen, and where on the page the canvas is.
import { areaOf, type Area, type Pt, type Rect } from '../geom/rect'
import {
  fitted,
  panned,
  revealed,
  seen,
  toScene,
  toScreen,
  zoomed,
  zoomedTo,
  PLAIN,
  type Size,
  type View as Seen,
} from '../geom/viewport'

/** Below this, names of pins are left out: nobody could read them, and text is what painting costs most. */
const NEAR = 0.6
/** Below this a pin is smaller than a pixel and a half: boxes are left without them. */
const TINY = 0.3
/** Below this nobody reads the names of boxes either. */
const UNREAD = 0.2
const MARGIN = 48

export class View {
  seen: Seen = $state.raw(PLAIN)
  size: Size = $state.raw({ w: 0, h: 0 })
  // Not asked anew at each step of a pan: hundreds of boxes depend on them.
  readonly isFar = $derived(this.seen.scale < NEAR)
  readonly isTiny = $derived(this.seen.scale < TINY)
  readonly isUnread = $derived(this.seen.scale < UNREAD)
  /** The upper left corner of the canvas on the page. */
  left = 0
  top = 0

  get scale(): number {
    return this.seen.scale
  }

  /** What is seen, in the scene's own pixels. */
  get area(): Area {
    return seen(this.seen, this.size)
  }

  get centre(): { x: number; y: number } {
    const { x0, x1, y0, y1 } = this.area
    return { x: (x0 + x1) / 2, y: (y0 + y1) / 2 }
  }

  /** Whether a place of the page is on the canvas. */
  holds(clientX: number, clientY: number): boolean {
    const [x, y] = [clientX - this.left, clientY - this.top]
    return x >= 0 && y >= 0 && x <= this.size.w && y <= this.size.h
  }

  /** The place of the scene for one of the page, as a pointer has it, and back. */
  toScene(clientX: number, clientY: number): Pt {
    return toScene(this.seen, [clientX - this.left, clientY - this.top])
  }

  toClient(x: number, y: number): Pt {
    const [px, py] = toScreen(this.seen, [x, y])
    return [px + this.left, py + this.top]
  }

  pan(dx: number, dy: number): void {
    this.seen = panned(this.seen, dx, dy)
  }

  /** Larger or smaller; what is at this place of the page stays there. */
  zoom(factor: number, clientX?: number, clientY?: number): void {
    this.seen = zoomed(this.seen, factor, this.fixed(clientX, clientY))
  }

  zoomTo(scale: number): void {
    this.seen = zoomedTo(this.seen, scale, this.fixed())
  }

  /** Show all of this, as large as it fits, but not larger than it is. */
  fit(rect: Rect): void {
    if (this.size.w && this.size.h) this.seen = fitted([areaOf(rect)], this.size, MARGIN)
  }

  centreOn(x: number, y: number): void {
    const { scale } = this.seen
    this.seen = { scale, x: this.size.w / 2 - x * scale, y: this.size.h / 2 - y * scale }
  }

  /** Move only as far as is needed to see this. */
  bringIn(rect: Rect): void {
    this.seen = revealed(this.seen, areaOf(rect), this.size, 24)
  }

  private fixed(clientX = this.left + this.size.w / 2, clientY = this.top + this.size.h / 2): Pt {
    return [clientX - this.left, clientY - this.top]
  }
}
