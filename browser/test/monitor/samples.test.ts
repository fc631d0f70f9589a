import { describe, expect, it } from 'vitest'
import { Samples } from '../../src/monitor/samples'
import { crossing } from '../../src/monitor/trigger'

const fast = { variable: 'd/F', last: 3, labels: ['F'], at_s: [1, 1.002, 1.004], rows: [[1], [2], [3]] }
const slow = { variable: 'd/M', last: 1, missed: 2, labels: ['M[0,0]', 'M[0,1]'], at_s: [1.002], rows: [[7, 8]] }

describe('values at every cycle', () => {
  // R-C14
  it('stand on one axis with the value in force, and in a table only where they were written', () => {
    const samples = new Samples()
    samples.take([fast, slow])
    const columns = samples.columns(['d/F', 'd/M'])
    const { t, y } = samples.stretch(columns, 1, 2)
    expect([...t]).toEqual([1, 1.002, 1.004])
    expect(y.map((column) => [...column])).toEqual([
      [1, 2, 3],
      [NaN, 7, 7],
      [NaN, 8, 8],
    ])
    expect(samples.csv(columns, 1, 2)).toBe(
      't_s,F,"M[0,0]","M[0,1]"\r\n0.000000,1,,\r\n0.002000,2,7,8\r\n0.004000,3,,\r\n',
    )
  })

  it('are asked for from the last one on, and what was lost is counted', () => {
    const samples = new Samples()
    samples.take([fast, slow])
    samples.take([{ ...fast, last: 9, missed: 5, at_s: [1.016], rows: [[9]] }])
    expect(samples.after(['d/F', 'd/M', 'd/X'])).toEqual([9, 1, 0])
    expect(samples.missed(['d/F', 'd/M'])).toBe(7)
    expect(samples.last_s(['d/F', 'd/M'])).toBe(1.016)
  })

  it('are kept for a bounded time', () => {
    const samples = new Samples()
    samples.take([fast])
    samples.take([{ ...fast, last: 4, at_s: [40], rows: [[4]] }])
    expect(samples.course(samples.columns(['d/F'])[0]!).t).toEqual([40])
  })
})

describe('a trigger', () => {
  const t = [0, 1, 2, 3, 4, 5, 6]
  const y = [0, 2, 0, 2, 0, 2, 0]
  it('is the newest crossing of the level in its direction that has enough behind it', () => {
    expect(crossing({ t, y }, 'rising', 1, 0)).toBe(5)
    expect(crossing({ t, y }, 'rising', 1, 2)).toBe(3)
    expect(crossing({ t, y }, 'falling', 1, 0)).toBe(6)
    expect(crossing({ t, y }, 'rising', 1, 0, 5)).toBeNaN()
    expect(crossing({ t, y }, 'rising', 3, 0)).toBeNaN()
    expect(crossing({ t: [], y: [] }, 'rising', 3, 0)).toBeNaN()
  })
})
