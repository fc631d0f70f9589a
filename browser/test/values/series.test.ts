import { describe, expect, it } from 'vitest'
import { numbers, Series } from '../../src/values/series'

describe('the past of a variable', () => {
  it('is what came since a time, with one sample before it', () => {
    const series = new Series(2)
    for (let k = 0; k < 10; k += 1) series.push(k, [k, -k])
    const { t, y } = series.since(6.5)
    expect([...t]).toEqual([6, 7, 8, 9])
    expect([...y[1]]).toEqual([-6, -7, -8, -9])
  })

  it('lies in one piece however often the ring went round', () => {
    const series = new Series(1, 7)
    for (let k = 0; k < 100; k += 1) {
      series.push(k, [10 * k])
      const { t, y } = series.all()
      expect([...t]).toEqual(Array.from({ length: Math.min(7, k + 1) }, (_, i) => Math.max(0, k - 6) + i))
      expect([...y[0]]).toEqual([...t].map((at) => 10 * at))
    }
  })

  it('is empty before the first sample', () => {
    expect(new Series(3).all().t).toHaveLength(0)
    expect(new Series(3).last_s).toBeNaN()
  })

  it('holds one sample for each time', () => {
    const series = new Series(1)
    series.push(1, [1])
    series.push(1, [2])
    expect([...series.all().y[0]]).toEqual([2])
  })

  it('drops a sample that was overtaken', () => {
    const series = new Series(1)
    for (const at_s of [1, 1.1, 1.05, 1.2]) series.push(at_s, [at_s])
    expect([...series.all().t]).toEqual([1, 1.1, 1.2])
  })

  it('begins anew when the clock does', () => {
    const series = new Series(1)
    series.push(100, [1])
    series.push(3, [2])
    series.push(4, [3])
    expect([...series.all().t]).toEqual([3, 4])
  })
})

describe('the numbers in a value', () => {
  it('are its elements row by row', () => {
    expect(numbers(2)).toEqual([2])
    expect(numbers(true)).toEqual([1])
    expect(
      numbers([
        [1, 2],
        [3, 4],
      ]),
    ).toEqual([1, 2, 3, 4])
  })

  it('are none where there is text', () => {
    expect(numbers('open')).toBeUndefined()
    expect(numbers([1, 'a'])).toBeUndefined()
    expect(numbers(null)).toBeUndefined()
  })
})
