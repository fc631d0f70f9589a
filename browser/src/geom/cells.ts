/** A spatial hash: which areas lie near an area, without looking at all of them. */

import { touches, type Area } from './rect'

const CELL = 128
const HALF = 32768 // cells to each side of the origin, about four million pixels

interface Entry<T> {
  readonly item: T
  seen: number
}

export class Cells<T extends Area> {
  private readonly cells = new Map<number, Entry<T>[]>()
  private readonly entries = new Map<T, Entry<T>>()
  private turn = 0

  add(item: T): void {
    const entry = { item, seen: 0 }
    this.entries.set(item, entry)
    for (const key of keys(item)) {
      const cell = this.cells.get(key)
      if (cell) cell.push(entry)
      else this.cells.set(key, [entry])
    }
  }

  drop(item: T): void {
    const entry = this.entries.get(item)
    if (!entry) return
    this.entries.delete(item)
    for (const key of keys(item)) {
      const cell = this.cells.get(key)!
      cell.splice(cell.indexOf(entry), 1)
      if (!cell.length) this.cells.delete(key)
    }
  }

  all(): IterableIterator<T> {
    return this.entries.keys()
  }

  /** The items that touch an area. */
  near(area: Area): T[] {
    const members: T[] = []
    const [i0, i1, j0, j1] = [column(area.x0), column(area.x1), column(area.y0), column(area.y1)]
    if ((i1 - i0 + 1) * (j1 - j0 + 1) > this.entries.size) {
      for (const item of this.entries.keys()) if (touches(item, area)) members.push(item)
      return members
    }
    const turn = ++this.turn // an item in several cells is reported once
    for (let i = i0; i <= i1; i++) {
      for (let j = j0; j <= j1; j++) {
        for (const entry of this.cells.get(i * 2 * HALF + j) ?? []) {
          if (entry.seen === turn) continue
          entry.seen = turn
          if (touches(entry.item, area)) members.push(entry.item)
        }
      }
    }
    return members
  }
}

const column = (v: number): number => Math.floor(v / CELL) + HALF

function* keys(a: Area): Generator<number> {
  for (let i = column(a.x0); i <= column(a.x1); i++) {
    for (let j = column(a.y0); j <= column(a.y1); j++) yield i * 2 * HALF + j
  }
}
