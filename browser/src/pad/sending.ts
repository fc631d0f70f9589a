// When a push is sent: often while it is held, seldom while it is not, and never behind many that are not answered.
// The runtime believes each for a moment only; so whatever hinders the next one lets the tool rest.

const HELD_MS = 33
const FREE_MS = 200
/** So many may be under way: what waited in a line would come all at once, too late. */
const UNANSWERED = 4

export class PushTimes {
  private sentAt = -Infinity
  private wasHeld = false
  private wasPressed = false
  private under = 0

  /** Whether a push is to be sent at this time, in ms. */
  isDue(now: number, isHeld: boolean, isPressed: boolean): boolean {
    if (this.under >= UNANSWERED) return false
    const isOther = isHeld !== this.wasHeld || isPressed !== this.wasPressed
    return isOther || now - this.sentAt >= (isHeld || isPressed ? HELD_MS : FREE_MS)
  }

  sent(now: number, isHeld: boolean, isPressed: boolean): void {
    this.sentAt = now
    this.wasHeld = isHeld
    this.wasPressed = isPressed
    this.under += 1
  }

  answered(): void {
    this.under -= 1
  }
}
