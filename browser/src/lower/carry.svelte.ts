// A task on its way from the library to the canvas. It follows the pointer once that has moved; Esc puts it back.

const MOVED_PX = 5

/** Whoever takes what is dropped; the canvas. */
export interface Ground {
  holds(x: number, y: number): boolean
  drop(task: string, x: number, y: number): void
}

class Carry {
  /** The library task under way; empty: none. */
  task = $state('')
  /** Where the pointer is, in pixels of the window. */
  x = $state(0)
  y = $state(0)
  isOverGround = $state(false)
  ground: Ground | undefined
  private letGo: (() => void) | undefined

  get isUnderWay(): boolean {
    return this.task !== ''
  }

  /** Call it at `pointerdown` on a cell of the library. A click that does not move carries nothing. */
  start(task: string, event: PointerEvent): void {
    if (event.button !== 0 || !event.isPrimary) return
    this.stop()
    const { clientX, clientY, pointerId } = event
    const move = (e: PointerEvent): void => {
      if (e.pointerId !== pointerId) return
      if (!this.task && Math.hypot(e.clientX - clientX, e.clientY - clientY) < MOVED_PX) return
      this.task = task
      this.follow(e)
    }
    const up = (e: PointerEvent): void => {
      if (e.pointerId === pointerId) this.drop()
    }
    const key = (e: KeyboardEvent): void => {
      if (e.key !== 'Escape' || !this.task) return
      e.preventDefault()
      e.stopPropagation()
      this.stop()
    }
    const cancel = (): void => this.stop()
    window.addEventListener('pointermove', move)
    window.addEventListener('pointerup', up)
    window.addEventListener('pointercancel', cancel)
    window.addEventListener('keydown', key, true)
    this.letGo = () => {
      window.removeEventListener('pointermove', move)
      window.removeEventListener('pointerup', up)
      window.removeEventListener('pointercancel', cancel)
      window.removeEventListener('keydown', key, true)
    }
  }

  /** Put it back where it came from. */
  stop(): void {
    this.letGo?.()
    this.letGo = undefined
    this.task = ''
    this.isOverGround = false
  }

  private follow(event: PointerEvent): void {
    this.x = event.clientX
    this.y = event.clientY
    this.isOverGround = this.ground?.holds(this.x, this.y) ?? false
  }

  private drop(): void {
    const { task, x, y, isOverGround } = this
    this.stop()
    if (task && isOverGround) this.ground?.drop(task, x, y)
  }
}

export const carry = new Carry()
