// What each thing in a row looks like, apart from where it stands: the same object again while it looks the same,
// so that an icon that has only moved is not drawn anew.
import type { ApplicationView, StepView } from '../api.gen'
import { EMPTY, END, START, type Cell } from './arrangement'

export interface Look {
  /** Of all that is drawn, also as the id of what is drawn. */
  readonly key: string
  readonly step: number
  readonly flow: string
  /** What is known of it; start, end and the room between them have nothing. */
  readonly view: StepView | undefined
  readonly left: string
  readonly right: string
  /** Digits of its picture. */
  readonly picture: string
}

export class Looks {
  private looks = new Map<string, Look>()

  /** How these look now. */
  of(app: ApplicationView, pictures: Readonly<Record<string, string>>, cells: readonly Cell[]): Look[] {
    const { looks } = this
    this.looks = new Map()
    return cells.map((cell) => {
      const now = lookOf(app, pictures, cell)
      const old = looks.get(now.key)
      const look = old && isSame(old, now) ? old : now
      this.looks.set(look.key, look)
      return look
    })
  }
}

function lookOf(app: ApplicationView, pictures: Readonly<Record<string, string>>, { step, flow }: Cell): Look {
  const view = step > 0 ? app.steps?.[step] : undefined
  const { start = '', end = '' } = app.flows?.[flow] ?? {}
  const left = step === START ? '' : step === END ? end : step === EMPTY ? start : view?.left
  const right = step === END ? '' : step === START ? start : step === EMPTY ? end : view?.right
  const picture = pictures[step === START ? 'start' : step === END ? 'end' : (view?.picture ?? '')]
  return { key: `${flow}-${step}`, step, flow, view, left: left ?? '', right: right ?? '', picture: picture ?? '' }
}

const isSame = (a: Look, b: Look): boolean =>
  a.view === b.view && a.left === b.left && a.right === b.right && a.picture === b.picture
