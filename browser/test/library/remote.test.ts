// Looking through a library of others.
import { expect, test } from 'vitest'
import type { OfferView } from '../../src/api.gen'
import { isUpToDate, offered } from '../../src/library/remote'

const OFFER: OfferView = {
  address: 'https://far.example/wings',
  name: 'wings',
  version: 2,
  until: '2027-02-24',
  signer: 'SHA256:k',
  digest: 'd',
  entries: [
    { kind: 'task', name: 'wink', description: 'a lamp that winks', writes: ['LAMP'] },
    { kind: 'task', name: 'blink', description: 'blinks', is_new: true },
    { kind: 'application', name: 'evening' },
  ],
}
const names = (wanted: string, onlyNew = false): string[] =>
  offered(OFFER, wanted, onlyNew).flatMap(([, entries]) => entries.map((entry) => entry.name))

test('what is offered stands by kinds, applications first', () => {
  expect(offered(OFFER, '', false).map(([kind]) => kind)).toEqual(['application', 'task'])
})

test('all words are looked for, in names, descriptions and variables', () => {
  expect(names('lamp WINK')).toEqual(['wink'])
  expect(names('nothing such')).toEqual([])
})

test('what is new can be looked at alone', () => {
  expect(names('', true)).toEqual(['blink'])
})

test('a library is up to date where its version is the one that is used and may be', () => {
  expect(isUpToDate({ ...OFFER, used: 2 })).toBe(true)
  expect(isUpToDate({ ...OFFER, used: 1 })).toBe(false)
  expect(isUpToDate({ ...OFFER, used: 2, refusal: { key: 'x', text: 'x' } })).toBe(false)
})
