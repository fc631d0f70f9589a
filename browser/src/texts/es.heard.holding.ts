// Español: lo que dice el entorno de quién puede mover los robots.
export const esHeardHolding: readonly (readonly [RegExp, string])[] = [
  [/^withdrawn$/, 'oferta retirada'],
  [/^(.+) declines$/, '{0} la rechaza'],
  [/^no answer within 60 s$/, 'sin respuesta en 60 s'],
  [/^Go on$/, 'Seguir'],
]
