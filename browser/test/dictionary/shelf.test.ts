// Where the icons of a dictionary stand, so that only what is seen need be drawn.
import { describe, expect, test } from 'vitest'
import type { Group } from '../../src/onikon/choose'
import { beside, CELL, columnsIn, linesOf, shelve } from '../../src/dictionary/shelf'

const group = (type: string, ...names: string[]): Group => ({ type, names, left: '1' })
const caption = (name: string): string => name

describe('the shelf', () => {
  const shelf = shelve(
    [group('Joint job', 'a', 'b', 'c', 'd'), group('Joint object', 'e')],
    3 * CELL.width,
    'pictures',
    caption,
  )

  test('has a row with the title of each group, and rows as wide as it is', () => {
    expect(shelf.rows.map((row) => row.group?.type ?? row.names.join())).toEqual([
      'Joint job',
      'a,b,c',
      'd',
      'Joint object',
      'e',
    ])
  })

  test('stands without gaps, and is as high as its rows', () => {
    for (const [k, row] of shelf.rows.entries())
      expect(row.top).toBe(k ? shelf.rows[k - 1]!.top + shelf.rows[k - 1]!.height : 0)
    expect(shelf.height).toBe(shelf.rows.reduce((sum, row) => sum + row.height, 0))
  })

  test('H04: has one column where only words are shown, and room for four lines beneath a picture at most', () => {
    expect(columnsIn(232, 'pictures')).toBe(3)
    expect(columnsIn(232, 'words')).toBe(1)
    const both = shelve([group('Joint job', 'a', 'b')], 232, 'both', (name) =>
      name === 'a' ? 'short' : 'a long description that goes on and on and on and on and on and on',
    )
    expect(both.rows[1]).toMatchObject({ lines: 4, height: CELL.icon + 4 * CELL.line + CELL.gap })
  })

  test('is walked by the arrow keys, over titles', () => {
    expect(beside(shelf.rows, 'b', 'ArrowDown')).toBe('d')
    expect(beside(shelf.rows, 'd', 'ArrowRight')).toBe('e')
  })
})

test.each([
  ['open', 1],
  ['above triangle', 2],
  ['averyverylongnamewithoutanyblank', 3],
  ['', 1],
])('%j beneath a picture takes %i lines', (text, lines) => expect(linesOf(text, 66)).toBe(lines))
