// What is drawn anew, and what has only moved.
import { describe, expect, test } from 'vitest'
import type { ApplicationView, StepView } from '../../src/api.gen'
import { EMPTY, END, START, type Cell } from '../../src/application/arrangement'
import { Looks } from '../../src/application/looks'

const icon = (name: string): StepView => ({ name, left: '1', right: '2', picture: name })
const steps = { 1: icon('grip'), 2: icon('open') }
const app = (more: Partial<ApplicationView> = {}): ApplicationView => ({
  name: 'play',
  order: 0,
  steps,
  flows: { 0: { steps: [1, 2], start: '3', end: '4' } },
  ...more,
})
const cells = (at: number, ...numbers: number[]): Cell[] =>
  numbers.map((step, k) => ({ step, flow: '0', x: at + 96 * k, y: at, w: 96 }))
const pictures = { start: 's', end: 'e', grip: 'g', open: 'o' }

describe('what a thing looks like', () => {
  test('has the edges where it stands, and those of its flow at the ends', () => {
    const looks = new Looks().of(app(), pictures, cells(0, START, 1, END, EMPTY))
    expect(looks.map(({ left, right, picture }) => [left, right, picture])).toEqual([
      ['', '3', 's'],
      ['1', '2', 'g'],
      ['4', '', 'e'],
      ['3', '4', ''],
    ])
    expect(looks.map(({ key }) => key)).toEqual(['0-0', '0-1', '0--1', '0--3'])
  })

  test('G07: is the same object where it has only moved, also when another comes before it', () => {
    const known = new Looks()
    const [start, grip, open, end] = known.of(app(), pictures, cells(0, START, 1, 2, END))
    const wider = app({ steps: { ...steps, 9: icon('grip') } })
    const after = known.of(wider, pictures, cells(50, START, 9, 1, 2, END))
    expect(after.filter(({ step }) => step !== 9)).toEqual([start, grip, open, end])
    for (const [k, one] of [start, grip, open, end].entries()) expect(after[k ? k + 1 : 0]).toBe(one)
  })

  test('is another where its icon, its edges or its picture are', () => {
    const known = new Looks()
    const [grip, open] = known.of(app(), pictures, cells(0, 1, 2))
    const [other, same] = known.of(
      app({ steps: { ...steps, 1: { ...icon('grip'), right: '5' } } }),
      pictures,
      cells(0, 1, 2),
    )
    expect(other).not.toBe(grip)
    expect(other!.right).toBe('5')
    expect(same).toBe(open)
    expect(known.of(app(), { ...pictures, open: 'painted' }, cells(0, 2))[0]).not.toBe(open)
  })
})
