// The small picture of the last seconds.
import { describe, expect, test } from 'vitest'
import { spark } from '../../src/canvas/spark'
import { Series } from '../../src/values/series'

function past(samples: number, width: number, value: (t: number, element: number) => number): Series {
  const series = new Series(width)
  for (let k = 0; k < samples; k += 1)
    series.push(
      k / 30,
      Array.from({ length: width }, (_, element) => value(k / 30, element)),
    )
  return series
}
const numbers = (d: string): [number, number][] =>
  d
    .slice(1)
    .split('L')
    .map((pair) => pair.split(' ').map(Number) as [number, number])

describe('a spark', () => {
  // R-C09, R-C14
  test('has one line for each element, six at most', () => {
    expect(spark(past(30, 3, Math.sin).all(), 0, 1, 100, 40)).toHaveLength(3)
    expect(spark(past(30, 9, Math.sin).all(), 0, 1, 100, 40)).toHaveLength(6)
  })

  test('stays within its picture and reaches the present', () => {
    const series = past(600, 2, (t, element) => 100 * Math.sin(t + element))
    const lines = spark(series.since(series.last_s - 8), series.last_s - 8, series.last_s, 154, 34)
    for (const points of lines.map(numbers)) {
      expect(points.every(([x, y]) => x >= 0 && x <= 154 && y >= 0 && y <= 34)).toBe(true)
      expect(points.at(-1)![0]).toBe(154)
    }
  })

  test('never has more points than pixels across', () => {
    const series = past(2000, 1, Math.cos)
    expect(numbers(spark(series.all(), 0, series.last_s, 100, 30)[0]!).length).toBeLessThanOrEqual(102)
  })

  test('of a value that stands still lies in the middle', () => {
    const points = numbers(spark(past(60, 1, () => 0).all(), 0, 2, 100, 30)[0]!)
    expect(points.every(([, y]) => Math.abs(y - 15) < 0.1)).toBe(true)
  })

  test('shows the rest where a value is no number', () => {
    const [line] = spark(past(60, 2, (t, element) => (element ? NaN : t)).all(), 0, 2, 100, 30)
    expect(numbers(line!).every(([, y]) => Number.isFinite(y))).toBe(true)
  })
})
