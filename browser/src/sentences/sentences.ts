// An application as plain sentences, flow by flow (X11). The descriptions are the user's; what joins them is ours.
import type { ApplicationView, TypeView } from '../api.gen'
import { type Connectives, fillOne, note, type Tale, textOf } from './tale'
import { Teller } from './teller'

/** The top flows of an application, in order. */
export function tell(
  app: ApplicationView,
  types: Readonly<Record<string, TypeView>>,
  connectives: Connectives,
): Tale[] {
  const tops = Object.keys(app.flows ?? {})
    .filter((path) => !path.includes('/'))
    .sort((path, other) => Number(path) - Number(other))
  return tops.map((path) => {
    const teller = new Teller(app, types, connectives, tops)
    const sentences = teller.flow(path, 0)
    if (!sentences.length) sentences.push(note(connectives.say('say.empty'), 0))
    return {
      path,
      title: fillOne(connectives.say('say.flow'), path),
      note: when(app, path, tops, connectives),
      sentences,
    }
  })
}

/** The sentence that speaks of a step, as it stands among those of its flow; empty where none does. */
export function sentenceOf(
  step: number,
  app: ApplicationView,
  types: Readonly<Record<string, TypeView>>,
  connectives: Connectives,
): string {
  const sentences = tell(app, types, connectives).flatMap((tale) => tale.sentences)
  const sentence = sentences.find(({ kind, steps }) => kind === 'action' && steps.includes(step))
  return sentence ? textOf(sentence) : ''
}

/** What each action is about, without its marks and times: "move the joints above the box"; a target's is its action's. */
export function briefs(
  app: ApplicationView,
  types: Readonly<Record<string, TypeView>>,
  connectives: Connectives,
): Map<number, string> {
  return new Teller(app, types, connectives, []).briefs()
}

function when(app: ApplicationView, path: string, tops: readonly string[], connectives: Connectives): string {
  if (app.is_parallel || tops.length < 2) return ''
  return path === '0' ? connectives.say('say.byDefault') : fillOne(connectives.say('say.onlyNested'), path)
}
