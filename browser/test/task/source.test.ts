// Two texts of one file: what differs, and what to keep.
import { describe, expect, test } from 'vitest'
import { around, differences, type Line } from '../../src/widgets/diff'

const written = (lines: (Line | null)[]): string =>
  lines.map((line) => (line ? `${{ both: ' ', first: '-', second: '+' }[line.kind]}${line.text}` : '...')).join('\n')
const side = (lines: Line[], kind: Line['kind']): string =>
  lines
    .filter((line) => line.kind === 'both' || line.kind === kind)
    .map((line) => line.text)
    .join('\n')

describe('differences', () => {
  test('name what each has alone', () => {
    expect(written(differences('a\nb\nc', 'a\nx\nc\nd'))).toBe(' a\n-b\n+x\n c\n+d')
  })

  test('of equal texts are none', () =>
    expect(differences('a\nb', 'a\nb').every((line) => line.kind === 'both')).toBe(true))

  test('give both texts back, whatever they are', () => {
    let seed = 5
    const next = (n: number): number => (seed = (seed * 16807) % 2147483647) % n
    const text = (): string => Array.from({ length: next(12) }, () => 'abcd'[next(4)]).join('\n')
    for (let k = 0; k < 500; k++) {
      const [a, b] = [text(), text()]
      const lines = differences(a, b)
      expect(side(lines, 'first')).toBe(a)
      expect(side(lines, 'second')).toBe(b)
    }
  })

  test('are shown with a few lines around them', () => {
    const long = Array.from({ length: 20 }, (_, k) => String(k))
    const changed = long.map((line) => (line === '10' ? 'x' : line))
    expect(written(around(differences(long.join('\n'), changed.join('\n')), 1))).toBe('...\n 9\n-10\n+x\n 11\n...')
  })
})
