import { describe, expect, it } from 'vitest'
import { camerasOf, pictureOf, pixelUnder, rateOf } from '../../src/values/cameras'

describe('cameras', () => {
  it('are in the answer to Scene where there are any', () => {
    const camera = { name: 'eye', width: 320, height: 240, rate: 10 }
    expect(camerasOf({ shapes: [], cameras: [camera] })).toEqual([camera])
    expect(camerasOf({ scene: { cameras: [camera] } })).toEqual([camera])
    expect(camerasOf({ shapes: [] })).toEqual([])
    expect(camerasOf(null)).toEqual([])
  })

  it('send pictures as JPEG or PNG', () => {
    expect(pictureOf({ file: 'iVBORw0', number: 1, at_s: 0.5 })).toEqual({
      number: 1,
      at_s: 0.5,
      url: 'data:image/png;base64,iVBORw0',
    })
    expect(pictureOf({ file: '/9j/4AA', number: 1, at_s: 0.5 })?.url).toBe('data:image/jpeg;base64,/9j/4AA')
    expect(pictureOf({ rows: [] })).toBeUndefined()
    expect(pictureOf(undefined)).toBeUndefined()
  })

  it('have the rate that their numbers and times say', () => {
    const [first, last] = [1, 11].map((number) => ({ number, at_s: number / 20, url: '' }))
    expect(rateOf(first, last!)).toBeCloseTo(20)
    expect(rateOf(last, last!)).toBeUndefined()
    expect(rateOf(undefined, last!)).toBeUndefined()
  })

  it('are pointed at in pixels from the upper left one, never beyond the edge', () => {
    const box = { left: 100, top: 50, width: 160, height: 120 }
    const size = { width: 320, height: 240 }
    expect(pixelUnder({ x: 180.25, y: 110.25 }, box, size)).toEqual([160, 120])
    expect(pixelUnder({ x: 100, y: 50 }, box, size)).toEqual([0, 0])
    expect(pixelUnder({ x: 260, y: 170 }, box, size)).toEqual([319, 239])
  })
})
