import { expect, test } from 'vitest'
import { Heap } from '../../src/geom/heap'
import { chance } from './scenes'

test('states come out by their cost, also beyond the first thousand', () => {
  const next = chance(7)
  const heap = new Heap()
  const costs = Array.from({ length: 5000 }, () => next())
  costs.forEach((cost, state) => heap.push(cost, state))
  const order: number[] = []
  while (!heap.empty) order.push(costs[heap.pop()])
  expect(order).toEqual([...costs].sort((a, b) => a - b))
})

test('a cleared heap is empty', () => {
  const heap = new Heap()
  heap.push(1, 1)
  heap.clear()
  expect(heap.empty).toBe(true)
})
