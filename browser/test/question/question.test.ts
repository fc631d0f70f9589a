import { describe, expect, it } from 'vitest'
import type { AskItem } from '../../src/api.gen'
import { complaint, ends, fields, first, line, pasted, step, stepped } from '../../src/question/question'

const item = (more: Partial<AskItem>): AskItem => ({
  name: 'endpoint',
  type: 'double',
  count: 1,
  unit: 'rad',
  meaning: '',
  ...more,
})
const field = (more: Partial<AskItem>) => fields({ items: [item(more)] })[0]

describe('the rows of a question (C13)', () => {
  it('are one for each element, with its bounds, default and present value', () => {
    const rows = fields({
      items: [
        item({ count: 2, low: [-1, -2], high: [1, 2], default: [0, 0.5] }),
        item({ name: 'duration', low: [0.1] }),
      ],
      present: { endpoint: [0.2, 0.3] },
    })
    expect(rows.map((row) => [row.item.name, row.index, row.low, row.high, row.isBounded, row.present])).toEqual([
      ['endpoint', 0, -1, 1, true, 0.2],
      ['endpoint', 1, -2, 2, true, 0.3],
      ['duration', 0, 0.1, Infinity, false, undefined],
    ])
    expect(rows.map(first)).toEqual(['0', '0.5', ''])
  })

  it('say their range in short, and never more than is allowed', () => {
    expect(ends(field({ low: [-2.79253], high: [2.79253] }))).toBe('−2.792 … 2.792')
    expect(ends(field({ low: [0.1], high: [600] }))).toBe('0.1 … 600')
    expect(ends(field({ low: [0] }))).toBe('0 …')
    expect(ends(field({}))).toBe('')
  })

  it('step in round parts of their range, whole numbers by one', () => {
    expect(step(field({ low: [-2.8], high: [2.8] }))).toBeCloseTo(0.01)
    expect(step(field({ type: 'int', low: [0], high: [1000] }))).toBe(1)
  })
})

describe('what is typed (C13)', () => {
  it.each([
    ['double', '', 'ask.empty'],
    ['double', 'abc', 'ask.number'],
    ['double', 'NaN', 'ask.finite'],
    ['double', '-inf', 'ask.finite'],
    ['double', '1e999', 'ask.finite'],
    ['double', '0x10', 'ask.number'],
    ['double', '1,5', 'ask.number'],
    ['int', '1.5', 'ask.whole'],
    ['byte', '256', 'ask.above'],
    ['byte', '-1', 'ask.below'],
    ['char', 'ab', 'ask.character'],
    ['string', 'two words', 'ask.word'],
  ])('%s %j is answered with %s', (type, text, key) => {
    expect(complaint(field({ type }), text)?.key).toBe(key)
  })

  it.each([
    ['double', ' 1.5 '],
    ['double', '-.5e-3'],
    ['int', '+7'],
    ['byte', '255'],
    ['char', ' '],
    ['string', ''],
    ['line', 'two "words"'],
  ])('%s %j is taken', (type, text) => {
    expect(complaint(field({ type }), text)).toBeUndefined()
  })

  it('is held against the bounds, which are part of the range', () => {
    const bounded = field({ low: [-160], high: [160] })
    expect(complaint(bounded, '214')).toEqual({ key: 'ask.above', found: '214', bound: '160' })
    expect(complaint(bounded, '-161')?.key).toBe('ask.below')
    expect(complaint(bounded, '160')).toBeUndefined()
  })
})

describe('the argument line (C13)', () => {
  it('quotes words that are empty or hold blanks or quotes', () => {
    expect(line(['1.5', '', 'two words', 'a"b', 'c\\d'])).toBe('1.5 "" "two words" "a\\"b" c\\d')
    expect(line(['a \\ "b"'])).toBe('"a \\\\ \\"b\\""')
  })
})

describe('Up and Down in a number', () => {
  const row = field({ low: [-1], high: [1] })
  const by = step(row)

  it('take one step, with Shift ten, and stay inside the bounds', () => {
    expect(Number(stepped(row, '0', { key: 'ArrowUp', shiftKey: false }))).toBeCloseTo(by)
    expect(Number(stepped(row, '0', { key: 'ArrowDown', shiftKey: true }))).toBeCloseTo(-10 * by)
    expect(stepped(row, '1', { key: 'ArrowUp', shiftKey: false })).toBe('1')
  })

  it('do nothing in what is no number, and other keys nothing at all', () => {
    expect(stepped(row, 'two', { key: 'ArrowUp', shiftKey: false })).toBeUndefined()
    expect(stepped(row, '0', { key: 'Enter', shiftKey: false })).toBeUndefined()
  })
})

describe('a pasted line', () => {
  it('gives one word for each field, whatever stands between the numbers', () => {
    for (const text of ['0.1 0.2 -3e-1', '0.1, 0.2, -3e-1', '[0.1,0.2,-3e-1]', '0.1;0.2;-3e-1', '0.1\t0.2\n-3e-1\n'])
      expect(pasted(text, field({}))).toEqual(['0.1', '0.2', '-3e-1'])
  })

  it('takes a comma within a number for a point where gaps part the numbers', () => {
    expect(pasted('0,5 1,25', field({}))).toEqual(['0.5', '1.25'])
  })

  it('is left to the field where it is one word, or the field takes a whole line', () => {
    expect(pasted('0.5', field({}))).toBeUndefined()
    expect(pasted('0,5', field({}))).toBeUndefined()
    expect(pasted('two words', field({ type: 'line' }))).toBeUndefined()
  })

  it('keeps quoted words together', () => {
    expect(pasted('"a b" 2', field({ type: 'string' }))).toEqual(['a b', '2'])
  })
})
