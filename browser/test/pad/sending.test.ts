// When a push is sent: often while it is held, seldom while it is not, never behind many unanswered ones.
import { expect, test } from 'vitest'
import { PushTimes } from '../../src/pad/sending'

/** At which of these instants, looked at every 10 ms, something is sent. */
function sent(times: PushTimes, until: number, isHeld: (at: number) => boolean, answers = true): number[] {
  const at: number[] = []
  for (let now = 0; now < until; now += 10) {
    if (!times.isDue(now, isHeld(now), false)) continue
    times.sent(now, isHeld(now), false)
    if (answers) times.answered()
    at.push(now)
  }
  return at
}

test('thirty times a second while it is held, five times while it is not', () => {
  expect(sent(new PushTimes(), 1000, () => true).length).toBe(25)
  expect(sent(new PushTimes(), 1000, () => false).length).toBe(5)
})

test('taking it and letting go are said at once', () => {
  expect(sent(new PushTimes(), 120, (at) => at >= 30 && at < 50)).toEqual([0, 30, 50])
})

test('where nothing is answered no more than four are under way', () => {
  const times = new PushTimes()
  expect(sent(times, 5000, () => true, false).length).toBe(4)
  times.answered()
  expect(times.isDue(6000, false, false)).toBe(true)
})
