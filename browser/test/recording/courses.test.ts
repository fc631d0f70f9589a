import { describe, expect, it } from 'vitest'
import type { StretchView } from '../../src/api.gen'
import { before, courseOf, Courses, RecordedPast, together } from '../../src/recording/courses'

const view = (label: string, least: number[], most: number[]): StretchView => ({
  label,
  unit: 'm',
  at_s: [0, 1, 2],
  least,
  most,
})

describe('A variable of a recorded run', () => {
  it('is one line that touches the least and the greatest value of each part, rising where it rises', () => {
    const course = courseOf([view('x', [0, 1, 0], [1, 3, 1])])!
    expect([...course.stretch.t]).toEqual([0, 0.5, 1, 1.5, 2, 2.5])
    expect([...course.stretch.y[0]!]).toEqual([0, 1, 1, 3, 1, 0])
    expect(courseOf([])).toBeUndefined()
  })

  it('is shown up to the instant that is looked at', () => {
    const past = new RecordedPast(courseOf([view('x', [0, 1, 2], [0, 1, 2])])!, 1.2)
    expect(past.last_s).toBe(1.2)
    expect([...past.since(0.9).t]).toEqual([0.5, 1])
    expect([...past.all().t]).toHaveLength(6)
    expect(before(past.all().t, -1)).toBe(-1)
  })

  it('is asked for once, however often it is drawn', async () => {
    const asked: string[] = []
    let come = 0
    const courses = new Courses(
      0,
      3,
      async (variable) => (asked.push(variable), [view('x', [0, 1, 2], [0, 1, 2])]),
      () => (come += 1),
    )
    expect(courses.of('a/X')).toBeUndefined()
    expect(courses.of('a/X')).toBeUndefined()
    await new Promise((done) => setTimeout(done))
    expect(courses.of('a/X')?.stretch.y).toHaveLength(1)
    expect(asked).toEqual(['a/X'])
    expect(come).toBe(1)
  })

  it('lies with that of another run on one line of time, each only as long as it lasted', () => {
    const one = { t: Float64Array.of(0, 2), y: [Float64Array.of(0, 4)] }
    const other = { t: Float64Array.of(0, 1, 3), y: [Float64Array.of(5, 5, 7)] }
    const both = together(one, other)
    expect([...both.t]).toEqual([0, 1, 2, 3])
    expect([...both.y[0]!]).toEqual([0, 2, 4, NaN])
    expect([...both.y[1]!]).toEqual([5, 5, 6, 7])
  })
})
