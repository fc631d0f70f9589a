// The types that somebody can make by hand: targets first, then what does nothing, each in the syntax's order (D08).
import type { TypeView } from '../api.gen'

export function kindsOf(types: Readonly<Record<string, TypeView>>): [string, TypeView][] {
  const rank = ({ role, order }: TypeView): number => (role === 'nop' ? 1e6 : 0) + order
  return Object.entries(types)
    .filter(([, type]) => type.role === 'target' || type.role === 'nop')
    .sort(([, a], [, b]) => rank(a) - rank(b))
}
