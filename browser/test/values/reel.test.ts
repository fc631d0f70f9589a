import { beforeEach, describe, expect, it } from 'vitest'
import type { Watch } from '../../src/api.gen'
import { Reel } from '../../src/values/reel'

const turn = () => new Promise((done) => setTimeout(done))

let told: Watch[]
let due: (() => void)[]
let reel: Reel
beforeEach(() => {
  told = []
  due = []
  reel = new Reel((wish) => told.push(wish), (run) => due.push(run))
})

describe('what is watched', () => {
  it('is told once for all that changes in one turn', async () => {
    reel.watch('1/Q')
    reel.watch('1/A')
    reel.watchWorld('boxes')
    await turn()
    expect(told).toEqual([{ t: 'Watch', variables: ['1/A', '1/Q'], worlds: ['boxes'], figures: false, hz: 30 }])
  })

  it('costs the same however many look at it, and ends with the last', async () => {
    const [one, other] = [reel.watch('1/Q'), reel.watch('1/Q')]
    await turn()
    one()
    one()
    await turn()
    expect(told).toHaveLength(1)
    other()
    await turn()
    expect(told[1].variables).toEqual([])
  })

  it('is not told where nobody watches anything', async () => {
    reel.watch('1/Q')()
    reel.again()
    await turn()
    expect(told).toEqual([])
  })

  it('is told again after a new connection', async () => {
    reel.watchFigures()
    await turn()
    reel.again()
    await turn()
    expect(told).toHaveLength(2)
    expect(told[1].figures).toBe(true)
  })
})

describe('a frame', () => {
  it('is kept only as far as it is watched', () => {
    reel.watch('1/Q')
    reel.receive({ t: 'Frame', at_s: 1, values: { '1/Q': [1, 2], '1/OTHER': 3 }, poses: { boxes: [] } })
    expect(reel.latest('1/Q')).toEqual([1, 2])
    expect(reel.series('1/Q')?.width).toBe(2)
    expect(reel.latest('1/OTHER')).toBeUndefined()
    expect(reel.poses('boxes')).toBeUndefined()
  })

  it('is forgotten when nobody watches any more', () => {
    const end = reel.watch('1/Q')
    reel.receive({ t: 'Frame', at_s: 1, values: { '1/Q': 1 } })
    end()
    expect(reel.series('1/Q')).toBeUndefined()
  })

  it('begins a new past where a variable has changed its size', () => {
    reel.watch('1/Q')
    reel.receive({ t: 'Frame', at_s: 1, values: { '1/Q': [1, 2] } })
    reel.receive({ t: 'Frame', at_s: 2, values: { '1/Q': [1, 2, 3] } })
    expect([...reel.series('1/Q')!.all().t]).toEqual([2])
  })

  it('keeps the newest text without a past', () => {
    reel.watch('1/S')
    reel.receive({ t: 'Frame', at_s: 1, values: { '1/S': 'open' } })
    expect(reel.latest('1/S')).toBe('open')
    expect(reel.series('1/S')).toBeUndefined()
  })

  it('calls who draws once for each picture of the screen', () => {
    let drawn = 0
    const end = reel.onFrame(() => (drawn += 1))
    reel.receive({ t: 'Frame', at_s: 1 })
    reel.receive({ t: 'Frame', at_s: 2 })
    expect(due).toHaveLength(1)
    due.pop()!()
    expect(drawn).toBe(1)
    end()
    reel.receive({ t: 'Frame', at_s: 3 })
    expect(due).toHaveLength(0)
  })

  it('without figures leaves those that are there', () => {
    reel.watchFigures()
    reel.receive({ t: 'Frame', at_s: 1, figures: { '1/pd': { cycle: 3 } } })
    reel.receive({ t: 'Frame', at_s: 2 })
    expect(reel.figures['1/pd'].cycle).toBe(3)
  })
})
