// How the icons of a dictionary stand: rows of cells of known height, so that only what is seen is drawn.
import type { Presentation } from '../state/look.svelte'
import { walked, type Span } from '../geom/rows'
import type { Group } from '../onikon/choose'

export const CELL = { width: 72, icon: 36, line: 12.5, word: 30, head: 25, gap: 7 }
const LETTER = 5.3 // pixels of a letter beneath an icon, at the width of the page's narrowest usual face
const MOST_LINES = 4
const WORD_WIDTH = 190

export interface Row extends Span {
  readonly key: string
  readonly names: readonly string[]
  /** Of a row that only names a group. */
  readonly group?: Group
  /** How many lines of words stand beneath each of its icons. */
  readonly lines: number
}

export interface Shelf {
  readonly rows: readonly Row[]
  readonly height: number
}

export function columnsIn(width: number, presentation: Presentation): number {
  return Math.max(1, Math.floor(width / (presentation === 'words' ? WORD_WIDTH : CELL.width)))
}

/** How many lines a text takes where a line is so many pixels wide; never more than are shown. */
export function linesOf(text: string, width: number): number {
  const letters = Math.max(1, Math.floor(width / LETTER))
  let [lines, length] = [1, 0]
  for (const word of text.split(/\s+/)) {
    if (length > 0 && length + 1 + word.length > letters) [lines, length] = [lines + 1, 0]
    length += (length ? 1 : 0) + word.length
    while (length > letters) [lines, length] = [lines + 1, length - letters]
  }
  return Math.min(lines, MOST_LINES)
}

/** Groups on a shelf so wide; `caption` says what stands beneath an icon. */
export function shelve(
  groups: readonly Group[],
  width: number,
  presentation: Presentation,
  caption: (name: string) => string,
): Shelf {
  const columns = columnsIn(width, presentation)
  const rows: Row[] = []
  let top = 0
  const add = (row: Omit<Row, 'top'>): void => {
    rows.push({ ...row, top })
    top += row.height
  }
  for (const group of groups) {
    add({ key: `type ${group.type}`, height: CELL.head, names: [], group, lines: 0 })
    for (let k = 0; k < group.names.length; k += columns) {
      const names = group.names.slice(k, k + columns)
      const lines =
        presentation === 'both' ? Math.max(...names.map((name) => linesOf(caption(name), width / columns - 6))) : 0
      add({ key: names[0]!, names, lines, height: heightOf(presentation, lines) })
    }
  }
  return { rows, height: top }
}

const heightOf = (presentation: Presentation, lines: number): number =>
  presentation === 'words' ? CELL.word : CELL.icon + lines * CELL.line + CELL.gap

/** The icon beside one, as the arrow keys go. */
export const beside = (rows: readonly Row[], name: string, key: string): string | undefined =>
  walked(
    rows.filter((row) => row.names.length).map((row) => row.names),
    name,
    key,
  )
