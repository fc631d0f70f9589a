import { describe, expect, it } from 'vitest'
import type { ParameterView, TaskView } from '../../src/api.gen'
import { isDefault, linesWith, readWord, rowsOf } from '../../src/task/parameters'

const parameter = (more: Partial<ParameterView>): ParameterView => ({
  name: 'STIFF',
  words: ['1'],
  shape: 'double',
  ...more,
})
const task = (local: [string, string[]][]): TaskView => ({
  name: 'pd',
  module: 'pd',
  library: '/l',
  order: 0,
  description: '',
  width: 0,
  height: 0,
  pins: [],
  local,
})

describe('the rows of a parameter', () => {
  it('are one with a slider where it is a number between two bounds', () => {
    expect(rowsOf(parameter({ low: 0.1, high: 2 })).map((row) => [row.low, row.high, row.isBounded])).toEqual([
      [0.1, 2, true],
    ])
    expect(rowsOf(parameter({ low: 0 })).map((row) => row.isBounded)).toEqual([false])
    expect(rowsOf(parameter({ shape: 'line', low: 0, high: 1 })).map((row) => row.isBounded)).toEqual([false])
  })

  it('are one for each element of a vector, and none where nothing is declared', () => {
    expect(rowsOf(parameter({ shape: 'double[NDOF]', words: ['1', '2'], low: 0, high: 3 })).length).toBe(2)
    expect(rowsOf(parameter({ shape: '' }))).toEqual([])
  })
})

describe('the LOCAL lines that a change makes', () => {
  const lines: [string, string[]][] = [
    ['DEVICE', ['w:arm']],
    ['STIFF', ['1']],
  ]

  it('keep all other lines and their order', () => {
    expect(linesWith(task(lines), parameter({}), ['1.5'])).toEqual([lines[0], ['STIFF', ['1.5']]])
    expect(linesWith(task([lines[0]]), parameter({}), ['1.5'])).toEqual([lines[0], ['STIFF', ['1.5']]])
  })

  it('have none for a parameter that is emptied and has a default', () => {
    expect(linesWith(task(lines), parameter({ default: ['1.0'] }), [])).toEqual([lines[0]])
    expect(linesWith(task(lines), parameter({}), [])).toEqual([lines[0], ['STIFF', []]])
  })
})

it('a parameter is at its default where it has none, or its words are those', () => {
  expect([
    isDefault(parameter({})),
    isDefault(parameter({ default: ['1'] })),
    isDefault(parameter({ default: ['2'] })),
  ]).toEqual([true, true, false])
})

it('a default that another unit made long is read in six digits, and other words as they are', () => {
  expect(['2.86478897565', '1.0', 'a_long_word', '0.12345'].map(readWord)).toEqual([
    '2.86479',
    '1.0',
    'a_long_word',
    '0.12345',
  ])
})
