// Where on its shelf something that is carried would be put: before or behind one of its neighbours (D24).
import type { Ground } from './carry.svelte'

export interface Shelf {
  /** What scrolls, with all that stands on it. */
  view(): HTMLElement | undefined
  /** What the id of a cell begins with, before its name. */
  prefix: string
  /** Those among which something may be put, in their order, it among them. */
  neighbours(name: string): readonly string[]
  /** Whether cells stand below each other only. */
  isColumn(): boolean
  /** Put it before another; empty: behind the last. */
  put(name: string, before: string): void
}

export class ShelfPlace implements Ground {
  /** The cell beside which it would be put. */
  beside = $state('')
  isBehind = $state(false)
  private readonly shelf: Shelf

  constructor(shelf: Shelf) {
    this.shelf = shelf
  }

  holds(x: number, y: number): boolean {
    return this.shelf.view()?.contains(document.elementFromPoint(x, y)) ?? false
  }

  hover(name: string, x: number, y: number): void {
    const cell = document.elementFromPoint(x, y)?.closest(`[id^="${this.shelf.prefix}"]`)
    const other = cell?.id.slice(this.shelf.prefix.length) ?? ''
    const isNeighbour = other !== name && this.shelf.neighbours(name).includes(other)
    this.beside = isNeighbour ? other : ''
    if (!cell || !isNeighbour) return
    const { left, top, width, height } = cell.getBoundingClientRect()
    this.isBehind = this.shelf.isColumn() ? y > top + height / 2 : x > left + width / 2
  }

  leave(): void {
    this.beside = ''
  }

  drop(name: string, x: number, y: number): void {
    this.hover(name, x, y)
    const { beside, isBehind } = this
    this.leave()
    if (!beside) return
    const names = this.shelf.neighbours(name)
    const before = placeOf(names, name, beside, isBehind)
    if (before !== placeNow(names, name)) this.shelf.put(name, before)
  }

  /** The mark that a cell bears. */
  markOf(name: string): 'before' | 'behind' | '' {
    if (name !== this.beside) return ''
    return this.isBehind ? 'behind' : 'before'
  }
}

/** Before which of these something comes that is put beside another; empty: behind the last. */
export function placeOf(names: readonly string[], name: string, beside: string, isBehind: boolean): string {
  const others = names.filter((other) => other !== name)
  return isBehind ? (others[others.indexOf(beside) + 1] ?? '') : beside
}

/** Before which it stands now. */
export const placeNow = (names: readonly string[], name: string): string => names[names.indexOf(name) + 1] ?? ''

/** Before which it comes one place earlier or later; undefined: it stands at that end. */
export function placeBy(names: readonly string[], name: string, by: -1 | 1): string | undefined {
  const at = names.indexOf(name)
  if (at < 0 || !(at + by in names)) return undefined
  return by < 0 ? names[at - 1] : (names[at + 2] ?? '')
}
