import { describe, expect, it } from 'vitest'
import { placesOf, sizesOf, standsOf, upperSizesOf } from '../../src/shell/windowPlaces'
import type { Stands } from '../../src/state/look.svelte'

const page = { width: 1440, height: 900 }
const lower = { library: 300, sheet: 320, strip: 250 }
const upper = { dictionary: 260, run: 340, words: 140 }
const plain: Stands = { bar: 'above', buttons: 'beside', variables: 'together' }
const other: Stands = { bar: 'below', buttons: 'beneath', variables: 'beside' }

describe('places of windows', () => {
  it('are those of the panels, and make the same panels again', () => {
    const places = placesOf(page, lower, upper, plain)
    expect(places.canvas).toEqual({ x: 300, y: 0, height: 650, width: 820 })
    expect(places.status).toEqual({ x: 0, y: 650 })
    const others = { library: 1, sheet: 1, strip: 1 }
    expect(sizesOf(places, page, others)).toEqual(lower)
    expect(upperSizesOf(places, page, { dictionary: 1, run: 1, words: 1 })).toEqual(upper)
  })

  it('that nobody has chosen leave the panels as they are', () => {
    expect(sizesOf({}, page, lower)).toEqual(lower)
    expect(upperSizesOf({ dictionary: { x: 0, y: 0, height: 480, width: 400 } }, page, upper)).toEqual({
      ...upper,
      dictionary: 400,
    })
  })

  it('of a larger screen make no panel smaller than it can be', () => {
    const places = placesOf({ width: 3000, height: 2000 }, lower, upper, plain)
    expect(sizesOf(places, page, lower)).toEqual({ library: 300, sheet: 220, strip: 34 })
    expect(upperSizesOf(places, page, upper)).toEqual({ dictionary: 260, run: 240, words: 34 })
  })

  it.each([400, 808, 900, 1200, 2000])('say what stands where, at a height of %i, and where it came from', (height) => {
    for (const width of [900, 990, 1440])
      for (const strip of [34, 128, 206, height - 208])
        for (const stands of [plain, other, { ...plain, bar: 'below' as const }, { ...other, bar: 'above' as const }]) {
          const places = placesOf({ width, height }, { ...lower, strip }, upper, stands)
          expect(standsOf(places, plain)).toEqual(stands)
          expect(places.main).not.toEqual({ x: 0, y: 760 })
          expect(places.variables).not.toEqual({ x: 330, y: 680 })
        }
  })

  it('of windows that nobody has moved leave everything where it stands', () => {
    expect(standsOf({}, other)).toEqual(other)
    expect(standsOf({ library: { x: 0, y: 0, height: 480, width: 400 } }, plain)).toEqual(plain)
  })

  it('as the first Onika wrote them stand as they stood there', () => {
    const places = {
      status: { x: 0, y: 400 },
      variables: { x: 500, y: 400 },
      main: { x: 0, y: 5 },
      buttons: { x: 9, y: 700 },
    }
    expect(standsOf(places, plain)).toEqual({ bar: 'above', buttons: 'beneath', variables: 'beside' })
  })
})
