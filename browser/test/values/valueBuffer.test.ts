import { beforeEach, describe, expect, it } from 'vitest'
import type { Watch } from '../../src/api.gen'
import { ValueBuffer } from '../../src/values/valueBuffer'

const turn = () => new Promise((done) => setTimeout(done))

let told: Watch[]
let due: (() => void)[]
let buffer: ValueBuffer
beforeEach(() => {
  told = []
  due = []
  buffer = new ValueBuffer(
    (wish) => told.push(wish),
    (run) => due.push(run),
  )
})

describe('what is watched', () => {
  it('is told once for all that changes in one turn', async () => {
    buffer.watch('1/Q')
    buffer.watch('1/A')
    buffer.watchWorld('boxes')
    await turn()
    expect(told).toEqual([{ t: 'Watch', variables: ['1/A', '1/Q'], worlds: ['boxes'], figures: false, hz: 30 }])
  })

  it('costs the same however many look at it, and ends with the last', async () => {
    const [one, other] = [buffer.watch('1/Q'), buffer.watch('1/Q')]
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
    buffer.watch('1/Q')()
    buffer.again()
    await turn()
    expect(told).toEqual([])
  })

  it('is told again after a new connection', async () => {
    buffer.watchFigures()
    await turn()
    buffer.again()
    await turn()
    expect(told).toHaveLength(2)
    expect(told[1].figures).toBe(true)
  })
})

describe('a frame', () => {
  it('is kept only as far as it is watched', () => {
    buffer.watch('1/Q')
    buffer.receive({ t: 'Frame', at_s: 1, values: { '1/Q': [1, 2], '1/OTHER': 3 }, poses: { boxes: [] } })
    expect(buffer.latest('1/Q')).toEqual([1, 2])
    expect(buffer.series('1/Q')?.width).toBe(2)
    expect(buffer.latest('1/OTHER')).toBeUndefined()
    expect(buffer.poses('boxes')).toBeUndefined()
  })

  it('is forgotten when nobody watches any more', () => {
    const end = buffer.watch('1/Q')
    buffer.receive({ t: 'Frame', at_s: 1, values: { '1/Q': 1 } })
    end()
    expect(buffer.series('1/Q')).toBeUndefined()
  })

  it('begins a new past where a variable has changed its size', () => {
    buffer.watch('1/Q')
    buffer.receive({ t: 'Frame', at_s: 1, values: { '1/Q': [1, 2] } })
    buffer.receive({ t: 'Frame', at_s: 2, values: { '1/Q': [1, 2, 3] } })
    expect([...buffer.series('1/Q')!.all().t]).toEqual([2])
  })

  it('keeps the newest text without a past', () => {
    buffer.watch('1/S')
    buffer.receive({ t: 'Frame', at_s: 1, values: { '1/S': 'open' } })
    expect(buffer.latest('1/S')).toBe('open')
    expect(buffer.series('1/S')).toBeUndefined()
  })

  it('calls who draws once for each picture of the screen', () => {
    let drawn = 0
    const end = buffer.onFrame(() => (drawn += 1))
    buffer.receive({ t: 'Frame', at_s: 1 })
    buffer.receive({ t: 'Frame', at_s: 2 })
    expect(due).toHaveLength(1)
    due.pop()!()
    expect(drawn).toBe(1)
    end()
    buffer.receive({ t: 'Frame', at_s: 3 })
    expect(due).toHaveLength(0)
  })

  it('without figures leaves those that are there', () => {
    buffer.watchFigures()
    buffer.receive({ t: 'Frame', at_s: 1, figures: { '1/pd': { cycle: 3 } } })
    buffer.receive({ t: 'Frame', at_s: 2 })
    expect(buffer.figures['1/pd'].cycle).toBe(3)
  })
})
