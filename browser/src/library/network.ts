// Other sites, as they are looked through: by what is wanted of them, and by words.
import type { NetworkSiteView, UsedLibraryView } from '../api.gen'
import type { Station } from '../link/stations'

export type Wanted = 'runtime' | 'library'

/** What a site offers of what is wanted. */
export const offersOf = (site: NetworkSiteView, wanted: Wanted): { address: string; about: string }[] =>
  wanted === 'library'
    ? (site.libraries ?? []).map((address) => ({ address, about: '' }))
    : (site.runtimes ?? []).map(({ address, robots }) => ({ address, about: (robots ?? []).join(', ') }))

/** The addresses of libraries that connected runtimes supply and that are not used yet, each with the first station. */
export function suppliedIn(stations: readonly Station[], used: readonly UsedLibraryView[]): [string, string][] {
  const known = new Set(used.map(({ address }) => address))
  const supplied = new Map<string, string>()
  for (const [station, runtime] of stations)
    for (const address of runtime.libraries ?? [])
      if (!known.has(address) && !supplied.has(address)) supplied.set(address, station)
  return [...supplied]
}

/** The sites that have all of the words, and something of what is wanted. */
export function sitesWith(sites: readonly NetworkSiteView[], wanted: Wanted, text: string): NetworkSiteView[] {
  const words = text.toLowerCase().split(/\s+/).filter(Boolean)
  return sites.filter(
    (site) => offersOf(site, wanted).length > 0 && words.every((word) => textOf(site, wanted).includes(word)),
  )
}

/** Whether what it offers may be used before its key was looked at: not where somebody else may bear its name. */
export const isUsable = (site: NetworkSiteView): boolean => site.standing === 'known' || site.standing === 'new'

/** Whether its key can be trusted from here. */
export const isTrustable = (site: NetworkSiteView): boolean =>
  site.standing === 'new' || site.standing === 'namesake' || site.standing === 'other_key'

const textOf = (site: NetworkSiteView, wanted: Wanted): string =>
  [site.name, site.description ?? '', ...offersOf(site, wanted).flatMap(({ address, about }) => [address, about])]
    .join(' ')
    .toLowerCase()
