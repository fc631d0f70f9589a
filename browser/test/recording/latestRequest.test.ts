import { describe, expect, it } from 'vitest'
import { LatestRequest } from '../../src/recording/latestRequest'

/** An environment that answers when it is told to, and a screen that is drawn when it is told to. */
function bench() {
  const asked: number[] = []
  const shown: string[] = []
  const lost: unknown[] = []
  const answers: ((text: string | Error) => void)[] = []
  let due: (() => void)[] = []
  const request = new LatestRequest<string>(
    (at_s) => {
      asked.push(at_s)
      return new Promise((done, failed) => answers.push((text) => (text instanceof Error ? failed(text) : done(text))))
    },
    (answer, at_s) => shown.push(`${answer}@${at_s}`),
    (why) => lost.push(why),
    (run) => due.push(run),
  )
  const frame = (): void => {
    const now = due
    due = []
    for (const run of now) run()
  }
  const answer = async (text: string | Error): Promise<void> => {
    answers.shift()!(text)
    await new Promise((done) => setTimeout(done))
  }
  return { request, asked, shown, lost, frame, answer }
}

describe('Scrubbing asks', () => {
  it('once for each picture of the screen, the newest wish', () => {
    const { request, asked, frame } = bench()
    for (const at_s of [1, 2, 3]) request.want(at_s)
    expect(asked).toEqual([])
    frame()
    expect(asked).toEqual([3])
  })

  it('never twice at a time: what was wished meanwhile is asked for after the answer, only the last of it', async () => {
    const { request, asked, shown, frame, answer } = bench()
    request.want(1)
    frame()
    for (const at_s of [2, 3, 4]) request.want(at_s)
    frame()
    expect(asked).toEqual([1])
    await answer('one')
    frame()
    expect(asked).toEqual([1, 4])
    await answer('four')
    expect(shown).toEqual(['one@1', 'four@4'])
  })

  it('goes on after an answer that did not come', async () => {
    const { request, asked, lost, frame, answer } = bench()
    request.want(1)
    frame()
    request.want(2)
    await answer(new Error('gone'))
    frame()
    expect(asked).toEqual([1, 2])
    expect(lost).toHaveLength(1)
  })

  it('takes no answer about a recording that was put away', async () => {
    const { request, shown, frame, answer } = bench()
    request.want(1)
    frame()
    request.forget()
    await answer('late')
    frame()
    expect(shown).toEqual([])
  })
})
