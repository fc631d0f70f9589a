// What a library of others offers, as it is looked through.
import type { OfferEntryView, OfferView } from '../api.gen'

export type EntryKind = 'application' | 'configuration' | 'icon' | 'task' | 'world'
export const KINDS: readonly EntryKind[] = ['application', 'configuration', 'icon', 'task', 'world']

/** The entries that have all of the words that are looked for, by kinds; kinds without any are left out. */
export function offered(offer: OfferView, wanted: string, onlyNew: boolean): [EntryKind, OfferEntryView[]][] {
  const words = wanted.toLowerCase().split(/\s+/).filter(Boolean)
  const matches = (offer.entries ?? []).filter(
    (entry) => (!onlyNew || entry.is_new) && words.every((word) => textOf(entry).includes(word)),
  )
  const byKind = KINDS.map((kind): [EntryKind, OfferEntryView[]] => [
    kind,
    matches.filter((entry) => entry.kind === kind),
  ])
  return byKind.filter(([, entries]) => entries.length > 0)
}

/** Whether the library is used just as it is offered. */
export const isUpToDate = (offer: OfferView): boolean => offer.used === offer.version && !offer.refusal

const textOf = (entry: OfferEntryView): string =>
  [entry.name, entry.description ?? '', ...(entry.writes ?? []), ...(entry.touches ?? [])].join(' ').toLowerCase()
