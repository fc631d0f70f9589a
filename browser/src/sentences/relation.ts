// A condition on a variable in words: `GRIP_MEZ[0] < 0.05` is "GRIP_MEZ[0] is below 0.05".
export type RelationKey = 'say.is' | 'say.isNot' | 'say.below' | 'say.above' | 'say.atMost' | 'say.atLeast'

const FORM = /^\s*(\S+?)\s*(==|!=|<=|>=|<|>)\s*([+-]?[\d.]+(?:[eE][+-]?\d+)?)\s*$/
const KEYS: Record<string, RelationKey> = {
  '==': 'say.is',
  '!=': 'say.isNot',
  '<': 'say.below',
  '>': 'say.above',
  '<=': 'say.atMost',
  '>=': 'say.atLeast',
}

/** What is not of this form stays as it is. */
export function inWords(
  condition: string,
  say: (key: RelationKey) => string,
  number: (value: number) => string,
): string {
  const [, variable, relation, value] = FORM.exec(condition) ?? []
  if (variable === undefined || relation === undefined || value === undefined) return condition.trim()
  return say(KEYS[relation]!)
    .replace('{variable}', variable)
    .replace('{value}', number(Number(value)))
}
