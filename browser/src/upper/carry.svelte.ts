// An icon on its way from a dictionary into a flow. It follows the pointer once that has moved; Esc puts it back.

const MOVED_PX = 5

/** Whoever takes what is dropped; the workspace. */
export interface Ground {
  holds(x: number, y: number): boolean
  /** It hovers there now; the place where it would go opens. */
  hover(onikon: string, x: number, y: number): void
  /** It is not there any more. */
  leave(): void
  drop(onikon: string, x: number, y: number): void
}

class Carry {
  /** The icon under way, by its name in the dictionaries; empty: none. */
  onikon = $state('')
  /** Where the pointer is, in pixels of the window. */
  x = $state(0)
  y = $state(0)
  isOverGround = $state(false)
  ground: Ground | undefined
  private letGo: (() => void) | undefined

  get isUnderWay(): boolean {
    return this.onikon !== ''
  }

  /** Call it at `pointerdown` on an icon of a dictionary. A click that does not move carries nothing. */
  begin(onikon: string, event: PointerEvent): void {
    if (event.button !== 0 || !event.isPrimary) return
    this.stop()
    const { clientX, clientY, pointerId } = event
    const ending = new AbortController()
    const { signal } = ending
    window.addEventListener('pointermove', (e) => {
      if (e.pointerId !== pointerId) return
      if (!this.onikon && Math.hypot(e.clientX - clientX, e.clientY - clientY) < MOVED_PX) return
      this.onikon = onikon
      this.follow(e)
    }, { signal })
    window.addEventListener('pointerup', (e) => {
      if (e.pointerId === pointerId) this.drop()
    }, { signal })
    window.addEventListener('pointercancel', () => this.stop(), { signal })
    window.addEventListener('keydown', (e) => {
      if (e.key !== 'Escape' || !this.onikon) return
      e.preventDefault()
      e.stopPropagation()
      this.stop()
    }, { signal, capture: true })
    this.letGo = () => ending.abort()
  }

  /** Put it back where it came from. */
  stop(): void {
    this.letGo?.()
    this.letGo = undefined
    if (this.isOverGround) this.ground?.leave()
    this.onikon = ''
    this.isOverGround = false
  }

  private follow(event: PointerEvent): void {
    this.x = event.clientX
    this.y = event.clientY
    const wasOver = this.isOverGround
    this.isOverGround = this.ground?.holds(this.x, this.y) ?? false
    if (this.isOverGround) this.ground?.hover(this.onikon, this.x, this.y)
    else if (wasOver) this.ground?.leave()
  }

  private drop(): void {
    const { onikon, x, y, isOverGround } = this
    this.stop()
    if (onikon && isOverGround) this.ground?.drop(onikon, x, y)
  }
}

export const carry = new Carry()

/** Begin to carry an icon, at `pointerdown` on it. */
export const begin = (onikon: string, event: PointerEvent): void => carry.begin(onikon, event)
