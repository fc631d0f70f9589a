// Something on its way from a library to where it is used. It follows the pointer once that has moved; Esc puts it back.

import { note } from '../link/note'
import { look } from '../state/look.svelte'

const MOVED_PX = 5

/** Whoever takes what is dropped: a canvas, a workspace. */
export interface Ground {
  holds(x: number, y: number): boolean
  /** It hovers there now. */
  hover?(name: string, x: number, y: number): void
  /** It is not there any more. */
  leave?(): void
  drop(name: string, x: number, y: number): void
}

export class Carry {
  /** What is under way, by its name; empty: nothing. */
  name = $state('')
  /** Where the pointer is, in pixels of the window. */
  x = $state(0)
  y = $state(0)
  isOverGround = $state(false)
  ground: Ground | undefined
  /** Where it came from, within which it may be put elsewhere. */
  shelf: Ground | undefined
  private over: Ground | undefined
  private letGo: (() => void) | undefined

  /** `window` is that of the library or dictionary, as the diary calls it. */
  constructor(private readonly window: 'lexi' | 'dict') {}

  get isUnderWay(): boolean {
    return this.name !== ''
  }

  /** Call it at `pointerdown` on what may be carried. A click that does not move carries nothing. */
  begin(name: string, event: PointerEvent): void {
    if (event.button !== 0 || !event.isPrimary) return
    this.stop()
    const { clientX, clientY, pointerId } = event
    const ending = new AbortController()
    const { signal } = ending
    window.addEventListener(
      'pointermove',
      (e) => {
        if (e.pointerId !== pointerId) return
        if (!this.name && Math.hypot(e.clientX - clientX, e.clientY - clientY) < MOVED_PX) return
        this.begins(name)
        this.follow(e)
      },
      { signal },
    )
    window.addEventListener(
      'pointerup',
      (e) => {
        if (e.pointerId === pointerId) this.drop()
      },
      { signal },
    )
    window.addEventListener('pointercancel', () => this.stop(), { signal })
    window.addEventListener(
      'keydown',
      (e) => {
        if (e.key !== 'Escape' || !this.name) return
        e.preventDefault()
        e.stopPropagation()
        this.cancelled()
      },
      { signal, capture: true },
    )
    this.letGo = () => ending.abort()
  }

  /** Put it back where it came from. */
  stop(): void {
    this.letGo?.()
    this.letGo = undefined
    this.over?.leave?.()
    this.over = undefined
    this.name = ''
    this.isOverGround = false
  }

  /** Where it may be dropped comes to the front of a narrow page. */
  private begins(name: string): void {
    if (!this.name && this.ground) look.column = 'desk'
    this.name = name
  }

  private follow(event: PointerEvent): void {
    this.x = event.clientX
    this.y = event.clientY
    const over = [this.ground, this.shelf].find((ground) => ground?.holds(this.x, this.y))
    if (over !== this.over) this.over?.leave?.()
    this.over = over
    this.isOverGround = over !== undefined && over === this.ground
    over?.hover?.(this.name, this.x, this.y)
  }

  private drop(): void {
    const { name, x, y, over } = this
    if (name && !over) return this.cancelled()
    this.stop()
    if (!name) return
    note('end_drag', name, name, this.window, `${Math.round(x)},${Math.round(y)}`)
    over?.drop(name, x, y)
  }

  /** It is put back, and the diary hears of it: no act says so. */
  private cancelled(): void {
    note('cancel_drag', this.name, this.name, this.window)
    this.stop()
  }
}

/** A task, from the library to the canvas. */
export const carriedTask = new Carry('lexi')
/** A task that may not be placed, within its library only. */
export const shelvedTask = new Carry('lexi')
/** An icon, from a dictionary into a flow. */
export const carriedIcon = new Carry('dict')
