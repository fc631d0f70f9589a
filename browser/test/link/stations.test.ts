// The stations of the environment, as the page lists them.
import { describe, expect, it } from 'vitest'
import { fullTree } from '../../src/link/desk.svelte'
import { runtimeAt, stationsIn, stoppedIn, worldAt, worldFor, worldsIn } from '../../src/link/stations'

const tree = fullTree({
  runtime: { state: 'linked', worlds: { boxes: true } },
  stations: { cmu: { state: 'linked', is_stopped: true, worlds: { boxes: true, 'boxes@2': true } }, far: {} },
})

describe('stations', () => {
  it('has the first one ahead, without a name', () => {
    expect(stationsIn(tree).map(([name]) => name)).toEqual(['', 'cmu', 'far'])
    expect(runtimeAt(tree, 'cmu').is_stopped).toBe(true)
    expect(runtimeAt(tree)).toBe(tree.runtime)
    expect(runtimeAt(tree, 'gone')).toEqual({})
  })
  it('tells worlds of one name apart by their station', () => {
    expect(worldsIn(tree)).toEqual(['boxes', 'cmu/boxes', 'cmu/boxes@2'])
    expect(worldsIn(tree).map(worldAt)).toEqual([
      ['', 'boxes'],
      ['cmu', 'boxes'],
      ['cmu', 'boxes@2'],
    ])
  })
  it('looks at the world that was picked, else at one that the open program drives, else at the first', () => {
    const worlds = ['hall', 'cmu/stand', 'stand']
    expect(worldFor(worlds, 'stand', ['hall'])).toBe('stand')
    expect(worldFor(worlds, '', ['stand'])).toBe('cmu/stand')
    expect(worldFor(worlds, 'gone', ['bench'])).toBe('hall')
    expect(worldFor([], 'hall', ['hall'])).toBe('')
  })
  it('knows where all is stopped', () => {
    expect(stoppedIn(tree).map(([name]) => name)).toEqual(['cmu'])
  })
})
