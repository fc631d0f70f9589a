import { expect, it } from 'vitest'
import { withWord, Writer } from '../../src/task/writing'

it('while one value is on its way the newest of the others waits, and is sent', async () => {
  const sent: number[][] = []
  const ends: (() => void)[] = []
  const writer = new Writer(
    (values) => {
      sent.push(values)
      return new Promise((resolve) => ends.push(resolve))
    },
    () => Promise.resolve(),
  )
  const settle = () => new Promise((resolve) => setTimeout(resolve))
  writer.put([1])
  writer.put([2])
  writer.put([3])
  expect(sent).toEqual([[1]])
  ends.shift()!()
  await settle()
  expect(sent).toEqual([[1], [3]])
  ends.shift()!()
  await settle()
  writer.put([4])
  expect(sent).toEqual([[1], [3], [4]])
})

it('a word becomes one of the numbers, or nothing changes', () => {
  expect(withWord([1, 2], 1, ' 0,5 ')).toEqual([1, 0.5])
  expect(withWord([1, 2], 0, '−3')).toEqual([-3, 2])
  for (const word of ['', 'x', 'Infinity']) expect(withWord([1], 0, word)).toBeUndefined()
})
