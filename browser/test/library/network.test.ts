// Other sites, as a dialog looks through them.
import { describe, expect, it } from 'vitest'
import type { NetworkSiteView, RuntimeView, UsedLibraryView } from '../../src/api.gen'
import { isTrustable, isUsable, offersOf, sitesWith, suppliedIn } from '../../src/library/network'

const site = (name: string, more: Partial<NetworkSiteView> = {}): NetworkSiteView => ({
  name,
  signer: 'SHA256:x',
  standing: 'new',
  until: '2027-01-01',
  ...more,
})
const cmu = site('cmu', { runtimes: [{ address: 'wss://cmu:1', robots: ['puma', 'hand'] }] })
const sandia = site('sandia', { description: 'Drawing boards', libraries: ['https://sandia/x'] })

describe('sites', () => {
  it('are listed by what is wanted of them', () => {
    expect(sitesWith([cmu, sandia], 'runtime', '').map((one) => one.name)).toEqual(['cmu'])
    expect(sitesWith([cmu, sandia], 'library', '').map((one) => one.name)).toEqual(['sandia'])
    expect(offersOf(cmu, 'runtime')).toEqual([{ address: 'wss://cmu:1', about: 'puma, hand' }])
  })
  it('are found by words of name, description, robots and addresses', () => {
    expect(sitesWith([cmu], 'runtime', 'PUMA cmu')).toEqual([cmu])
    expect(sitesWith([cmu], 'runtime', 'puma rover')).toEqual([])
    expect(sitesWith([sandia], 'library', 'boards')).toEqual([sandia])
  })
  it('are used without a look at the key only where nobody else bears the name', () => {
    const standings = ['known', 'new', 'namesake', 'other_key', 'older', 'overdue'] as const
    expect(standings.filter((standing) => isUsable(site('x', { standing })))).toEqual(['known', 'new'])
    expect(standings.filter((standing) => isTrustable(site('x', { standing })))).toEqual([
      'new',
      'namesake',
      'other_key',
    ])
  })
})

describe('libraries that connected runtimes supply', () => {
  const runtime = (...libraries: string[]): RuntimeView => ({ libraries }) as RuntimeView
  const used = [{ name: 'x', address: 'https://used' }] as unknown as UsedLibraryView[]

  it('are those that are not used yet, each once, with the first runtime that names it', () => {
    const stations: [string, RuntimeView][] = [
      ['', runtime('https://a', 'https://used')],
      ['cmu', runtime('https://b', 'https://a')],
      ['sandia', {} as RuntimeView],
    ]
    expect(suppliedIn(stations, used)).toEqual([
      ['https://a', ''],
      ['https://b', 'cmu'],
    ])
  })
})
