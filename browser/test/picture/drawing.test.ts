import { describe, expect, it } from 'vitest'
import { at, blank, isPicture, painted, resized } from '../../src/geom/pixels'
import { after, begun, nextZoom, redone, Stroke, TOOLS, undone } from '../../src/picture/drawing'

describe('a drawing (D07)', () => {
  const one = painted(blank(), [[3, 3]], '0')
  const two = painted(one, [[4, 4]], '1')

  it('takes its steps back one by one, and does them again', () => {
    const drawn = after(after(begun(blank()), one), two)
    expect(undone(drawn).picture).toBe(one)
    expect(undone(undone(drawn)).picture).toBe(blank())
    expect(undone(undone(undone(drawn))).picture).toBe(blank())
    expect(redone(redone(undone(undone(drawn))))).toEqual(drawn)
    expect(redone(drawn)).toBe(drawn)
  })

  it('forgets what was taken back when something else is drawn', () => {
    const drawn = after(undone(after(begun(blank()), one)), two)
    expect(redone(drawn).picture).toBe(two)
    expect(undone(drawn).picture).toBe(blank())
  })

  it('is given back whole after it was made smaller (B09)', () => {
    const large = painted(blank(64), [[33, 33]], '0')
    const small = after(begun(large), resized(large, 32))
    expect(undone(small).picture).toBe(large)
    expect(redone(undone(small)).picture).toBe(small.picture)
  })

  it('is painted at three sizes (B09)', () => {
    expect([1, 2, 3].map((zoom) => nextZoom(zoom, 1))).toEqual([2, 3, 3])
    expect([1, 2, 3].map((zoom) => nextZoom(zoom, -1))).toEqual([1, 1, 2])
  })

  it('has no step for what changes nothing', () => {
    expect(after(begun(one), one).past).toEqual([])
    expect(after(begun(one), resized(one, 32)).past).toEqual([])
  })
})

describe('a stroke (D07)', () => {
  it('of the pen is where it went, without gaps', () => {
    const stroke = new Stroke('pen', blank(), [2, 2], '0')
    stroke.to([6, 2])
    const picture = stroke.to([6, 5])
    for (const [x, y] of [
      [2, 2],
      [4, 2],
      [6, 2],
      [6, 4],
      [6, 5],
    ])
      expect(at(picture, x, y)).toBe('0')
    expect(at(picture, 3, 3)).toBe('7')
  })

  it.each(['line', 'rectangle', 'circle'] as const)('of the %s follows the pointer and leaves no trail', (tool) => {
    const stroke = new Stroke(tool, blank(), [5, 5], '2')
    stroke.to([25, 8])
    expect(stroke.to([12, 12])).toBe(new Stroke(tool, blank(), [5, 5], '2').to([12, 12]))
  })

  it('fills shapes where that is wished', () => {
    expect(at(new Stroke('rectangle', blank(), [5, 5], '2', true).to([9, 9]), 7, 7)).toBe('2')
    expect(at(new Stroke('rectangle', blank(), [5, 5], '2').to([9, 9]), 7, 7)).toBe('7')
  })

  it.each(TOOLS)('of the %s leaves the black border alone (B11)', (tool) => {
    const stroke = new Stroke(tool, blank(), [0, 0], '0', true)
    expect(isPicture(stroke.to([31, 31]))).toBe(true)
  })

  it('of the filling tool ends at another colour', () => {
    const wall = new Stroke('rectangle', blank(), [5, 5], '2').to([15, 15])
    const picture = new Stroke('fill', wall, [10, 10], '3').to([10, 10])
    expect(at(picture, 6, 6)).toBe('3')
    expect(at(picture, 4, 4)).toBe('7')
  })
})
