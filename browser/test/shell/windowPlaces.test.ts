import { describe, expect, it } from 'vitest'
import { placesOf, sizesOf, upperSizesOf } from '../../src/shell/windowPlaces'

const page = { width: 1440, height: 900 }
const lower = { library: 300, sheet: 320, strip: 250 }
const upper = { dictionary: 260, run: 340, words: 140 }

describe('places of windows', () => {
  it('are those of the panels, and make the same panels again', () => {
    const places = placesOf(page, lower, upper)
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
    const places = placesOf({ width: 3000, height: 2000 }, lower, upper)
    expect(sizesOf(places, page, lower)).toEqual({ library: 300, sheet: 220, strip: 34 })
    expect(upperSizesOf(places, page, upper)).toEqual({ dictionary: 260, run: 240, words: 34 })
  })
})
