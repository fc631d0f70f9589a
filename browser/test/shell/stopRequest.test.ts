// A Stop that nobody answers is said to be so (X12, law 27).
import { afterEach, beforeEach, expect, it, vi } from 'vitest'
import { StopRequest } from '../../src/shell/stopRequest.svelte'

beforeEach(() => void vi.useFakeTimers())
afterEach(() => void vi.useRealTimers())

it('is late after a second without an answer, and says for how long', () => {
  const asked = new StopRequest()
  asked.begin()
  vi.advanceTimersByTime(900)
  expect(asked.isLate).toBe(false)
  vi.advanceTimersByTime(2200)
  expect([asked.isLate, asked.seconds]).toEqual([true, 3])
  asked.begin() // asked again: it counts from the first
  vi.advanceTimersByTime(1000)
  expect(asked.seconds).toBe(4)
  asked.answered()
  expect([asked.isLate, asked.seconds]).toEqual([false, 0])
  vi.advanceTimersByTime(5000)
  expect(asked.isLate).toBe(false)
})

it('goes on as long as one of them may still be answered', () => {
  const asked = new StopRequest()
  asked.begin()
  asked.begin()
  vi.advanceTimersByTime(1500)
  asked.failed()
  expect(asked.isLate).toBe(true)
  asked.failed()
  expect(asked.isLate).toBe(false)
})
