// For whom robots are booked, as the panel lists and draws it.
import { describe, expect, it } from 'vitest'
import type { BookView, RuntimeView } from '../../src/api.gen'
import {
  aheadS,
  barsOf,
  byPerson,
  clockOf,
  currentOf,
  dayOf,
  dayStart,
  fieldOf,
  hoursOf,
  lengthOf,
  momentOf,
  robotsIn,
  siteNow,
} from '../../src/holding/booking'

const HOUR = 3600
const NOON = Date.UTC(2026, 10, 24, 12) / 1000
const booking = (number: number, user: string, from: number, to: number) => ({
  number,
  user,
  begin_s: NOON + from * HOUR,
  end_s: NOON + to * HOUR,
})
const book = (more: Partial<BookView> = {}): BookView => ({
  robot: 'arm',
  you: 'ann',
  now_s: NOON,
  asked_s: NOON,
  bookings: [booking(1, 'bob', -1, 1), booking(2, 'ann', 23, 30)],
  ...more,
})
const linked = (one: BookView): RuntimeView => ({ state: 'linked', address: 'wss://far:1', book: one })

describe('bookings', () => {
  it('are reckoned by the clock of the site, whose error is told', () => {
    const far = book({ now_s: NOON + HOUR })
    expect(siteNow(far, NOON + 10)).toBe(NOON + HOUR + 10)
    expect([aheadS(far), aheadS(book({ now_s: NOON + 2 }))]).toEqual([HOUR, 0])
  })
  it('tell whose time it is', () => {
    expect(currentOf(book(), NOON)?.user).toBe('bob')
    expect(currentOf(book(), NOON + HOUR)).toBeUndefined()
  })
  it('are bars of the day, cut where it begins and ends', () => {
    const bars = barsOf(book(), dayStart(NOON + 60))
    expect(bars.map(({ from, width }) => [from, width])).toEqual([
      [0, 1 / 24],
      [23 / 24, 1 / 24],
    ])
    expect(hoursOf(NOON).map(({ hour }) => hour)).toEqual([12, 15, 18, 21, 0, 3, 6, 9])
  })
  it('are listed by person, over all robots', () => {
    const second = book({ robot: 'rover', bookings: [booking(7, 'ann', 2, 3)] })
    const robots = robotsIn([
      ['', linked(book())],
      ['cmu', linked(second)],
      ['gone', { state: 'lost', book: book() }],
      ['none', { state: 'linked' }],
    ])
    expect(byPerson(robots).map(({ user, bookings }) => [user, bookings.map((one) => one.robot.book.robot)])).toEqual([
      ['ann', ['rover', 'arm']],
      ['bob', ['arm']],
    ])
  })
  it('are written in UTC', () => {
    expect([clockOf(NOON + 300), dayOf(NOON, NOON + 60, 'en')]).toEqual(['12:05', ''])
    expect(dayOf(NOON + 24 * HOUR, NOON, 'en')).toContain('25')
    expect([lengthOf(90 * 60), lengthOf(2 * HOUR), lengthOf(59)]).toEqual(['1 h 30 min', '2 h', '1 min'])
    expect(fieldOf(NOON + 1)).toBe('2026-11-24T12:05')
    expect(momentOf('2026-11-24T12:05')).toBe(NOON + 300)
  })
})
