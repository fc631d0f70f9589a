// For whom robots are booked, as numbers and lists; every time is reckoned by the clock of the robot's own site.
import type { BookingView, BookView, RuntimeView } from '../api.gen'
import type { Station } from '../link/stations'

export const STEP_S = 300
const HOUR_S = 3600
const DAY_S = 24 * HOUR_S
/** Clocks that differ by less are taken for the same. */
const SAME_S = 5

/** A runtime that keeps bookings, by its station. */
export interface BookedRobot {
  station: string
  runtime: RuntimeView
  book: BookView
}

export const robotsIn = (stations: readonly Station[]): BookedRobot[] =>
  stations.flatMap(([station, runtime]) =>
    runtime.state === 'linked' && runtime.book ? [{ station, runtime, book: runtime.book }] : [],
  )

/** What the time is at the robot's site, where it is `nowS` here. */
export const siteNow = (book: BookView, nowS: number): number => nowS + (book.now_s - book.asked_s)

/** By how many seconds the clock of the site is ahead of the one here; 0: they are the same. */
export function aheadS(book: BookView): number {
  const ahead = book.now_s - book.asked_s
  return Math.abs(ahead) < SAME_S ? 0 : ahead
}

/** Whose time it is. */
export const currentOf = (book: BookView, nowS: number): BookingView | undefined =>
  (book.bookings ?? []).find((booking) => booking.begin_s <= nowS && nowS < booking.end_s)

export const isYours = (book: BookView, booking: BookingView): boolean => booking.user === book.you

/** The bookings of one person at all robots, earliest first. */
export interface Person {
  user: string
  bookings: { robot: BookedRobot; booking: BookingView }[]
}

export function byPerson(robots: readonly BookedRobot[]): Person[] {
  const people = new Map<string, Person>()
  for (const robot of robots)
    for (const booking of robot.book.bookings ?? []) {
      const person = people.get(booking.user) ?? { user: booking.user, bookings: [] }
      person.bookings.push({ robot, booking })
      people.set(booking.user, person)
    }
  for (const person of people.values()) person.bookings.sort((a, b) => a.booking.begin_s - b.booking.begin_s)
  return [...people.values()].sort((a, b) => a.user.localeCompare(b.user))
}

/** A booking as a bar of the day that begins with an hour: where it begins and how long it is, of the whole. */
export interface Bar {
  booking: BookingView
  from: number
  width: number
}

export const dayStart = (nowS: number): number => Math.floor(nowS / HOUR_S) * HOUR_S

export function barsOf(book: BookView, startS: number, lengthS = DAY_S): Bar[] {
  return (book.bookings ?? []).flatMap((booking) => {
    const from = Math.max(booking.begin_s, startS)
    const to = Math.min(booking.end_s, startS + lengthS)
    return from < to ? [{ booking, from: (from - startS) / lengthS, width: (to - from) / lengthS }] : []
  })
}

/** The hours at which a day has a mark, each with its place in the whole. */
export const hoursOf = (startS: number, each = 3): { hour: number; from: number }[] =>
  Array.from({ length: 24 }, (_, k) => ({
    hour: new Date((startS + k * HOUR_S) * 1000).getUTCHours(),
    from: k / 24,
  })).filter(({ hour }) => hour % each === 0)

/** 14:05, in UTC. */
export function clockOf(atS: number): string {
  const date = new Date(atS * 1000)
  return `${String(date.getUTCHours()).padStart(2, '0')}:${String(date.getUTCMinutes()).padStart(2, '0')}`
}

export const dayOf = (atS: number, nowS: number, language: string): string =>
  Math.floor(atS / DAY_S) === Math.floor(nowS / DAY_S)
    ? ''
    : new Date(atS * 1000).toLocaleDateString(language, {
        timeZone: 'UTC',
        weekday: 'short',
        day: 'numeric',
        month: 'short',
      })

/** Hours and minutes of a length: 1 h 30 min. */
export function lengthOf(seconds: number): string {
  const minutes = Math.max(0, Math.round(seconds / 60))
  const [hours, rest] = [Math.floor(minutes / 60), minutes % 60]
  if (!hours) return `${rest} min`
  return rest ? `${hours} h ${rest} min` : `${hours} h`
}

/** What a field for a moment in UTC holds. */
export const fieldOf = (atS: number): string =>
  new Date(Math.ceil(atS / STEP_S) * STEP_S * 1000).toISOString().slice(0, 16)
/** The moment that such a field says; NaN: none. */
export const momentOf = (field: string): number => Date.parse(`${field}:00Z`) / 1000
